#include "bake/studio.hpp"

#include "bake/environment_sh.hpp"
#include "shading/host.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::bake {
namespace {

using glm::vec3;

class Studio : public ::testing::Test {
 protected:
  static float at(vec3 direction) {
    const auto uv = shading::equirect_uv(glm::normalize(direction));
    const auto x = std::min(static_cast<std::uint32_t>(uv.x * static_cast<float>(image().width)), image().width - 1);
    const auto y = std::min(static_cast<std::uint32_t>(uv.y * static_cast<float>(image().height)), image().height - 1);
    return image().rgba[4 * (static_cast<std::size_t>(y) * image().width + x)];
  }
  static const image::FloatImage& image() {
    static const image::FloatImage picture = studio_environment();
    return picture;
  }
  static float irradiance_over_pi(vec3 n) {
    const auto sh = project_sh(image());
    vec3 coefficients[9];
    for (std::size_t i = 0; i < 9; ++i) coefficients[i] = vec3(sh[i]);
    return shading::sh_irradiance(coefficients, n).x;
  }
};

TEST_F(Studio, IsNeutralFiniteAndAsBrightAsPromised) {
  ASSERT_EQ(image().width, 1024u);
  ASSERT_EQ(image().height, 512u);
  float peak = 0.0f;
  for (std::size_t i = 0; i < image().rgba.size(); i += 4) {
    const float* p = &image().rgba[i];
    ASSERT_TRUE(std::isfinite(p[0]) && p[0] > 0.0f);
    ASSERT_TRUE(p[0] == p[1] && p[0] == p[2] && p[3] == 1.0f);
    peak = std::max(peak, p[0]);
  }
  EXPECT_GE(peak, 15.0f);
  EXPECT_LE(peak, 25.0f);
  const float mean = project_sh(image())[0].x / std::sqrt(4.0f * 3.14159265f);
  EXPECT_GE(mean, 0.5f);
  EXPECT_LE(mean, 1.0f);
}

TEST_F(Studio, LampsHangWhereTheyShould) {
  const float walls = at({0, 0, -1});
  EXPECT_LT(walls, 0.2f);
  EXPECT_GT(at({0, 1, 0}), 2.0f);               // overhead
  EXPECT_GT(at({-0.75f, 0.34f, 0.75f}), 5.0f);  // key: left, and before the object
  EXPECT_GT(at({0.8f, 0.3f, -0.75f}), 15.0f);   // rim: right, and behind it
  EXPECT_GT(at({0, -1, 0}), 2.0f * walls);      // floor
}

TEST_F(Studio, LightsAMattObjectWell) {
  EXPECT_NEAR(irradiance_over_pi({0, 0, 1}), 0.7f, 0.2f);  // what faces the camera
  EXPECT_GT(irradiance_over_pi({-1, 0, 0}), irradiance_over_pi({1, 0, 0}));
  EXPECT_GT(irradiance_over_pi({0, -1, 0}), 0.1f);  // no side is black
}

TEST_F(Studio, EdgesAreNoStaircases) {
  // Half of a light's brightness is the most that two neighbouring pixels may differ by.
  const auto& picture = image();
  for (std::uint32_t y = 1; y < picture.height; ++y)
    for (std::uint32_t x = 1; x < picture.width; ++x) {
      const float* p = &picture.rgba[4 * (static_cast<std::size_t>(y) * picture.width + x)];
      const float left = p[-4], above = p[-4 * static_cast<std::ptrdiff_t>(picture.width)];
      ASSERT_LT(std::max(std::fabs(p[0] - left), std::fabs(p[0] - above)), 10.0f) << x << " " << y;
    }
}

}  // namespace
}  // namespace velarium::bake
