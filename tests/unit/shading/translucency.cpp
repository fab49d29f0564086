#include "shading/host.hpp"

#include <gtest/gtest.h>

namespace velarium::shading {
namespace {

TEST(Translucency, GreySheetsPassWhatCoverageLeaves) {
  for (const float grey : {0.0f, 0.2f, 1.0f})
    for (const float alpha : {0.0f, 0.25f, 1.0f}) {
      const vec3 passed = blend_transmittance(vec3(grey), alpha);
      EXPECT_FLOAT_EQ(passed.x, 1.0f - alpha);
      EXPECT_EQ(passed.x, passed.y);
      EXPECT_EQ(passed.x, passed.z);
    }
}

// Of red at alpha 1/2: half passes, of the other channels 1/2 (1/2 + 1/2 0.04 / 1.04).
TEST(Translucency, ColouredOnesDyeTheRest) {
  const vec3 passed = blend_transmittance({1.0f, 0.0f, 0.0f}, 0.5f);
  EXPECT_FLOAT_EQ(passed.x, 0.5f);
  EXPECT_NEAR(passed.y, 0.259615f, 1e-6f);
  EXPECT_FLOAT_EQ(passed.z, passed.y);
}

TEST(Translucency, ThinnerSheetsDyeLess) {
  const vec3 blue(0.1f, 0.2f, 0.9f);
  float before = 1.0f;
  for (const float alpha : {0.1f, 0.4f, 0.7f, 0.95f}) {
    const vec3 dye = blend_dye(blue, alpha);
    EXPECT_LT(dye.x, before);
    EXPECT_FLOAT_EQ(dye.z, 1.0f);
    before = dye.x;
  }
}

}  // namespace
}  // namespace velarium::shading
