#include "bake/environment_sh.hpp"

#include "shading/host.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace velarium::bake {
namespace {

using glm::vec3;

constexpr double kPi = 3.14159265358979323846;

image::FloatImage paint(std::uint32_t width, std::uint32_t height, const std::function<vec3(vec3)>& radiance) {
  image::FloatImage image{.width = width, .height = height};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                         (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      const vec3 value = radiance(shading::equirect_direction(uv));
      image.rgba.insert(image.rgba.end(), {value.x, value.y, value.z, 1.0f});
    }
  return image;
}

vec3 irradiance_over_pi(const image::FloatImage& image, vec3 n) {
  const auto sh = project_sh(image);
  vec3 coefficients[9];
  for (std::size_t i = 0; i < 9; ++i) coefficients[i] = vec3(sh[i]);
  return shading::sh_irradiance(coefficients, n);
}

TEST(ProjectSh, AConstantHasOneCoefficient) {
  // Even a picture of few pixels: the integrals over pixels are exact.
  for (const auto& [width, height] : {std::pair{1u, 1u}, std::pair{5u, 3u}, std::pair{64u, 32u}}) {
    const auto sh = project_sh(paint(width, height, [](vec3) { return vec3(0.5f, 1.0f, 4.0f); }));
    EXPECT_NEAR(sh[0].y, std::sqrt(4.0 * kPi), 1e-6);
    EXPECT_FLOAT_EQ(sh[0].x, 0.5f * sh[0].y);
    EXPECT_FLOAT_EQ(sh[0].z, 4.0f * sh[0].y);
    for (std::size_t i = 1; i < 9; ++i) EXPECT_NEAR(sh[i].y, 0.0f, 1e-6f) << i;
  }
}

TEST(ProjectSh, EachBasisFunctionFindsItself) {
  for (int which = 0; which < 9; ++which) {
    const auto image = paint(256, 128, [which](vec3 d) {
      float basis[9];
      shading::sh_basis(d, basis);
      return vec3(basis[which]);
    });
    const auto sh = project_sh(image);
    for (int i = 0; i < 9; ++i)
      EXPECT_NEAR(sh[static_cast<std::size_t>(i)].x, i == which ? 1.0f : 0.0f, 1e-3f) << which << " " << i;
  }
}

TEST(ProjectSh, IrradianceOfACosineLobe) {
  // Radiance max(0, d.y) has irradiance 2 pi / 3 straight above, 2/3 of pi; three bands say 0.6667 and hardly more.
  const auto image = paint(256, 128, [](vec3 d) { return vec3(std::max(d.y, 0.0f)); });
  EXPECT_NEAR(irradiance_over_pi(image, {0, 1, 0}).x, 2.0f / 3.0f, 0.01f);
}

TEST(ProjectSh, LightComesFromItsSide) {
  const auto lit_along = [](vec3 axis) {
    return paint(128, 64, [axis](vec3 d) { return vec3(glm::dot(d, axis) > 0.9f ? 10.0f : 0.0f); });
  };
  for (const vec3 axis :
       {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
    const auto image = lit_along(axis);
    const float facing = irradiance_over_pi(image, axis).x;
    // Solid angle 2 pi 0.1, mean cosine 0.95, over pi.
    EXPECT_NEAR(facing, 10.0f * 0.2f * 0.95f, 0.3f * facing);
    EXPECT_LT(irradiance_over_pi(image, -axis).x, 0.2f * facing);
  }
}

}  // namespace
}  // namespace velarium::bake
