#include "bake/sky.hpp"

#include "bake/environment_sh.hpp"
#include "shading/host.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::bake {
namespace {

using glm::vec3;

class Sky : public ::testing::Test {
 protected:
  static const image::FloatImage& image() {
    static const image::FloatImage picture = sky_environment();
    return picture;
  }
  static vec3 at(vec3 direction) {
    const auto uv = shading::equirect_uv(glm::normalize(direction));
    const auto x = std::min(static_cast<std::uint32_t>(uv.x * static_cast<float>(image().width)), image().width - 1);
    const auto y = std::min(static_cast<std::uint32_t>(uv.y * static_cast<float>(image().height)), image().height - 1);
    const float* p = &image().rgba[4 * (static_cast<std::size_t>(y) * image().width + x)];
    return {p[0], p[1], p[2]};
  }
};

TEST_F(Sky, IsFiniteAndAsBrightAsPromised) {
  ASSERT_EQ(image().width, 1024u);
  ASSERT_EQ(image().height, 512u);
  float peak = 0.0f;
  for (const float value : image().rgba) {
    ASSERT_TRUE(std::isfinite(value) && value > 0.0f);
    peak = std::max(peak, value);
  }
  EXPECT_LE(peak, 8.0f);
  EXPECT_GE(peak, 3.0f);
  const float mean = project_sh(image())[0].x / std::sqrt(4.0f * 3.14159265f);
  EXPECT_NEAR(mean, 0.45f, 0.05f);
}

TEST_F(Sky, IsGoldAtTheSunAndBlueOverhead) {
  const vec3 sun = at({-0.42f, 0.2f, -1.0f}), zenith = at({0.0f, 1.0f, 0.0f}), ground = at({0.0f, -1.0f, 0.0f});
  EXPECT_GT(sun.x, 3.0f * sun.z);
  EXPECT_GT(sun.x, 3.0f * at({0.42f, 0.2f, 1.0f}).x);
  EXPECT_GT(ground.x, ground.z);
  EXPECT_LT(ground.x, zenith.z);
}

}  // namespace
}  // namespace velarium::bake
