#include <gtest/gtest.h>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

void expect_near(const vec3& a, const vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Equirect, KnownDirections) {
  EXPECT_NEAR(equirect_uv(vec3(0, 1, 0)).y, 0.0f, 1e-6);
  EXPECT_NEAR(equirect_uv(vec3(0, -1, 0)).y, 1.0f, 1e-6);
  expect_near(vec3(equirect_uv(vec3(1, 0, 0)), 0.0f), vec3(0.5f, 0.5f, 0.0f), 1e-6);
  expect_near(vec3(equirect_uv(vec3(0, 0, 1)), 0.0f), vec3(0.75f, 0.5f, 0.0f), 1e-6);
  expect_near(vec3(equirect_uv(vec3(0, 0, -1)), 0.0f), vec3(0.25f, 0.5f, 0.0f), 1e-6);
}

TEST(Equirect, RoundTrips) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const vec3 d = random.direction();
    ASSERT_LT(angle_degrees(d, equirect_direction(equirect_uv(d))), 1e-4);
  }
}

// Faces as the Vulkan specification lays them out: what lies right of and below the centre.
TEST(Cube, FaceOrientation) {
  struct Row {
    uint face;
    vec3 center, right, down;
  };
  const Row rows[] = {{0, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {1, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                      {2, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {3, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                      {4, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {5, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
  for (const Row& row : rows) {
    expect_near(cube_direction(row.face, vec2(0.5f)), row.center, 1e-6);
    expect_near(cube_direction(row.face, vec2(1.0f, 0.5f)), normalize(row.center + row.right), 1e-6);
    expect_near(cube_direction(row.face, vec2(0.5f, 1.0f)), normalize(row.center + row.down), 1e-6);
    const CubeCoordinate c = cube_coordinate(row.center + 0.5f * row.right + 0.25f * row.down);
    EXPECT_EQ(c.face, row.face);
    EXPECT_NEAR(c.uv.x, 0.75f, 1e-6);
    EXPECT_NEAR(c.uv.y, 0.625f, 1e-6);
  }
}

TEST(Cube, RoundTrips) {
  Random random(2);
  for (int i = 0; i < 100000; ++i) {
    const vec3 d = random.direction();
    const CubeCoordinate c = cube_coordinate(3.0f * d);
    ASSERT_LT(angle_degrees(d, cube_direction(c.face, c.uv)), 2e-5);
  }
  for (uint face = 0; face < 6; ++face) {
    const CubeCoordinate c = cube_coordinate(cube_direction(face, vec2(0.1f, 0.8f)));
    EXPECT_EQ(c.face, face);
    EXPECT_NEAR(c.uv.x, 0.1f, 1e-6);
    EXPECT_NEAR(c.uv.y, 0.8f, 1e-6);
  }
}

TEST(Prefilter, LevelsAreLinearInSmoothness) {
  const float alphas[] = {0.000729f, 0.005233f, 0.023014f, 0.075419f, 0.203067f, 0.475059f, 1.0f};
  for (uint m = 0; m < kPrefilterLevels; ++m) {
    const float s = smoothness_of_level(static_cast<float>(m));
    EXPECT_NEAR(alpha_from_smoothness(std::max(s, 0.0f)), alphas[m], 1e-6) << m;
    EXPECT_NEAR(level_of_smoothness(s), static_cast<float>(m), 1e-5);
  }
}

// Radiance of bands 0 to 2 alone, so that nine coefficients hold all of it.
float smooth_radiance(const vec3& d) {
  return 2.0f + 0.6f * d.y - 0.3f * d.x + 0.4f * d.x * d.z + 0.5f * d.y * d.y - 0.7f * d.y * d.z;
}

TEST(SphericalHarmonics, IrradianceIsTheCosineIntegral) {
  vec3 coefficients[9] = {};
  const vec3 n = normalize(vec3(0.3f, -0.5f, 0.8f));
  constexpr int kSteps = 400;
  double exact = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < 2 * kSteps; ++j) {
      const vec3 d =
          equirect_direction({(static_cast<float>(j) + 0.5f) / (2 * kSteps), (static_cast<float>(i) + 0.5f) / kSteps});
      const double sr = std::sin(kPiExact * (i + 0.5) / kSteps) * kPiExact * kPiExact / (kSteps * kSteps);
      float basis[9];
      sh_basis(d, basis);
      for (int k = 0; k < 9; ++k) coefficients[k] += vec3(smooth_radiance(d) * basis[k] * static_cast<float>(sr));
      exact += smooth_radiance(d) * std::max(dot(n, d), 0.0f) * sr / kPiExact;
    }
  }
  EXPECT_NEAR(sh_irradiance(coefficients, n).y, exact, 1e-3);
}

TEST(SphericalHarmonics, UniformRadianceIsItsOwnMean) {
  vec3 coefficients[9] = {};
  coefficients[0] = vec3(1.0f, 2.0f, 3.0f) * 3.5449077f;  // sqrt(4 pi)
  expect_near(sh_irradiance(coefficients, vec3(0, 1, 0)), vec3(1.0f, 2.0f, 3.0f), 1e-5);
  coefficients[1] = vec3(-50.0f);
  EXPECT_EQ(sh_irradiance(coefficients, vec3(0, 1, 0)), vec3(0.0f));
}

}  // namespace
}  // namespace velarium::shading
