#include "bake/irradiance.hpp"

#include "shading/host.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace velarium {
namespace {

image::FloatImage make(std::uint32_t width, std::uint32_t height, glm::vec3 (*radiance)(const glm::vec3&)) {
  image::FloatImage image{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                         (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      const glm::vec3 value = radiance(shading::equirect_direction(uv));
      image.rgba.insert(image.rgba.end(), {value.x, value.y, value.z, 1.0f});
    }
  }
  return image;
}

TEST(Irradiance, ConstantLightIsItsOwnMean) {
  for (const auto& [width, height] : std::array{std::pair{2u, 1u}, std::pair{128u, 64u}, std::pair{333u, 150u}}) {
    const auto image = make(width, height, [](const glm::vec3&) { return glm::vec3(3.0f, 2.0f, 1.0f); });
    for (const auto& value : bake::irradiance_cube(image, 4)) {
      EXPECT_NEAR(value.x, 3.0f, 3e-3f) << width;
      EXPECT_NEAR(value.y, 2.0f, 2e-3f);
      EXPECT_NEAR(value.z, 1.0f, 1e-3f);
    }
  }
}

// Radiance max(d.y, 0): upwards the integral of cos^2 over the hemisphere / pi = 2/3, sideways 1/pi times the integral
// over the quarter sphere of d.y d.x = 1/3 * 2 / pi * ... = 2 / (3 pi), downwards 0.
TEST(Irradiance, CosineSkyHasClosedForm) {
  const auto image = make(512, 256, [](const glm::vec3& d) { return glm::vec3(std::max(d.y, 0.0f)); });
  EXPECT_NEAR(bake::irradiance(image, {0, 1, 0}).x, 2.0f / 3.0f, 1e-3f);
  EXPECT_NEAR(bake::irradiance(image, {1, 0, 0}).x, 2.0f / (3.0f * shading::kPi), 1e-3f);
  EXPECT_NEAR(bake::irradiance(image, {0, 0, -1}).x, 2.0f / (3.0f * shading::kPi), 1e-3f);
  EXPECT_NEAR(bake::irradiance(image, {0, -1, 0}).x, 0.0f, 1e-3f);
}

// A light at +X, a quarter of the way around from -Z: only faces that see it are lit, by its cosine.
TEST(Irradiance, CubeIsOrientedAsDirectionsAre) {
  const auto image = make(512, 256, [](const glm::vec3& d) { return glm::vec3(d.x > 0.99f ? 100.0f : 0.0f); });
  const std::uint32_t size = 8;
  const auto cube = bake::irradiance_cube(image, size);
  const float head_on = bake::irradiance(image, {1, 0, 0}).x;
  ASSERT_GT(head_on, 1.0f);
  for (std::uint32_t i = 0; i < cube.size(); ++i) {
    const glm::vec2 uv((static_cast<float>(i % size) + 0.5f) / size,
                       (static_cast<float>(i / size % size) + 0.5f) / size);
    const float cosine = shading::cube_direction(i / (size * size), uv).x;
    if (cosine > 0.2f) { EXPECT_NEAR(cube[i].x / head_on, cosine, 0.01f); }
    if (cosine < -0.2f) { EXPECT_EQ(cube[i].x, 0.0f); }
  }
}

}  // namespace
}  // namespace velarium
