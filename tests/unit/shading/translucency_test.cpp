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
    const vec3 tint = blend_tint(blue, alpha);
    EXPECT_LT(tint.x, before);
    EXPECT_FLOAT_EQ(tint.z, 1.0f);
    before = tint.x;
  }
}

// The nearest surface of a plane is farther downhill than what a bilinear reading reaches, one texel on both axes.
TEST(Translucency, VeilsLieBelowTheirOwnSurface) {
  EXPECT_FLOAT_EQ(translucency_depth(0.5f, {0.01f, -0.02f}), 0.46f);
  EXPECT_FLOAT_EQ(translucency_depth(0.5f, {0.02f, 0.02f}), 0.5f - 0.02f - 0.02f);
  EXPECT_EQ(translucency_depth(1.5f, {0.0f, 0.0f}), 1.0f);
  EXPECT_EQ(translucency_depth(0.1f, {0.2f, 0.0f}), 0.0f);
}

TEST(Translucency, OnlyWhatLiesBehindASheetIsDyed) {
  const vec4 texel(0.5f, 0.25f, 0.125f, 0.4f);
  const vec3 opaque(1.0f);
  EXPECT_EQ(map_transmittance(texel, 0.39f, opaque), vec3(0.5f, 0.25f, 0.125f));
  EXPECT_EQ(map_transmittance(texel, 0.41f, opaque), vec3(1.0f));
  // Rounding of the stored depth to a half, 2^-11 of it, brings no surface behind itself.
  EXPECT_EQ(map_transmittance({0.5f, 0.5f, 0.5f, 0.4f * (1.0f + 0x1p-11f)}, 0.4f, opaque), vec3(1.0f));
  EXPECT_EQ(map_transmittance({1.0f, 1.0f, 1.0f, 0.0f}, 0.0f, opaque), vec3(1.0f));
}

// A sheet of (1/2, 1/4, 1) behind one of (1/2, 1, 1/2): their product, but for its own part.
TEST(Translucency, SheetsAreNotDyedByTheirOwnPart) {
  const vec4 both(0.25f, 0.25f, 0.5f, 0.4f);
  EXPECT_EQ(map_transmittance(both, 0.3f, {0.5f, 0.25f, 1.0f}), vec3(0.5f, 1.0f, 0.5f));
  EXPECT_EQ(map_transmittance(both, 0.5f, {0.5f, 0.25f, 1.0f}), vec3(1.0f));
  EXPECT_EQ(map_transmittance({0.0f, 0.0f, 0.0f, 0.4f}, 0.3f, vec3(0.0f)), vec3(0.0f));
}

}  // namespace
}  // namespace velarium::shading
