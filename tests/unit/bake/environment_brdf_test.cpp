#include "bake/environment_brdf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "unit/shading/support.hpp"

namespace velarium::bake {
namespace {

using namespace shading;

constexpr uint kRings = 48;  // as the table's

struct Row {
  float n_dot_v;
  double e0, e1;
};

void expect_rows(float smoothness, uint model, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const vec2 e = integrate_environment_brdf(row.n_dot_v, alpha_from_smoothness(smoothness), model, kRings);
    EXPECT_NEAR(e.x, row.e0, 2e-3) << "s " << smoothness << " n.v " << row.n_dot_v;
    EXPECT_NEAR(e.y, row.e1, 2e-3) << "s " << smoothness << " n.v " << row.n_dot_v;
  }
}

// At smoothness 1/2 the values are those of 2560 x 5120 half vectors, sampled by D: 40 x 80, on which tables are often
// built, miss what the tail of GGX loses below the horizon and at grazing angles, up to 0.03.
TEST(EnvironmentBrdf, SmithIsTheTabledOne) {
  expect_rows(
      0.0f, kModelGltf,
      {{0.05f, .0322, .8480}, {0.25f, .0109, .5969}, {0.5f, .0030, .4507}, {0.75f, .0006, .3645}, {1.0f, 0, .3069}});
  expect_rows(
      0.5f, kModelGltf,
      {{0.05f, .4058, .9000}, {0.25f, .1918, .9477}, {0.5f, .0327, .9827}, {0.75f, .0017, .9908}, {1.0f, 0, .9935}});
  expect_rows(1.0f, kModelGltf,
              {{0.05f, .7736, .9999}, {0.25f, .2373, 1}, {0.5f, .0313, 1}, {0.75f, .0010, 1}, {1.0f, 0, 1}});
}

TEST(EnvironmentBrdf, RyseIsTheTabledOne) {
  expect_rows(
      0.0f, kModelRyse,
      {{0.05f, .0078, .3109}, {0.25f, .0040, .2987}, {0.5f, .0015, .2862}, {0.75f, .0004, .2747}, {1.0f, 0, .2640}});
  expect_rows(
      0.5f, kModelRyse,
      {{0.05f, .0268, .0783}, {0.25f, .0461, .2615}, {0.5f, .0162, .5413}, {0.75f, .0011, .7827}, {1.0f, 0, .9763}});
  expect_rows(
      1.0f, kModelRyse,
      {{0.05f, .0154, .0199}, {0.25f, .0617, .2601}, {0.5f, .0179, .5737}, {0.75f, .0008, .8164}, {1.0f, 0, 1}});
}

TEST(EnvironmentBrdf, MirrorsHaveClosedForms) {
  for (const float nv : {0.05f, 0.25f, 0.5f, 0.75f, 1.0f}) {
    const vec2 smith = integrate_environment_brdf(nv, 1e-5f, kModelGltf, kRings);
    EXPECT_NEAR(smith.x, std::pow(1.0 - nv, 5), 2e-3) << nv;
    EXPECT_NEAR(smith.y, 1.0, 2e-3) << nv;
    const vec2 ryse = integrate_environment_brdf(nv, 1e-5f, kModelRyse, kRings);
    EXPECT_NEAR(ryse.y, std::pow(nv / (0.68 * nv + 0.32), 2), 2e-3) << nv;
  }
}

TEST(EnvironmentBrdf, TableHasConverged) {
  constexpr uint kSize = 64;
  for (const uint model : {kModelGltf, kModelRyse}) {
    const std::vector<vec2> table = environment_brdf(kSize, model);
    ASSERT_EQ(table.size(), kSize * kSize);
    for (uint y = 0; y < kSize; y += 9) {
      for (uint x = 0; x < kSize; x += x < 4 ? 1 : 12) {
        const float nv = std::max(static_cast<float>(x) / (kSize - 1), 1e-3f),
                    smoothness = static_cast<float>(y) / (kSize - 1);
        const vec2 exact = integrate_environment_brdf(nv, alpha_from_smoothness(smoothness), model, 300);
        ASSERT_NEAR(table[y * kSize + x].x, exact.x, 6e-4) << model << ' ' << x << ' ' << y;
        ASSERT_NEAR(table[y * kSize + x].y, exact.y, 6e-4) << model << ' ' << x << ' ' << y;
      }
    }
  }
}

TEST(EnvironmentBrdf, NeverReflectsMoreThanArrives) {
  for (const uint model : {kModelGltf, kModelRyse}) {
    for (const vec2& e : environment_brdf(32, model)) {
      ASSERT_GE(e.x, 0.0f);
      ASSERT_GT(e.y, e.x);
      ASSERT_LE(e.y, 1.0006f);
    }
  }
}

// The table, compensation and diffuse weight together: a white surface in uniform light of 1 sends back 1.
TEST(EnvironmentBrdf, WhiteFurnaceClosesOverTheTable) {
  for (const vec2& e : environment_brdf(32, kModelGltf)) {
    for (const float f0 : {0.02f, 0.04f, 0.5f, 1.0f}) {
      const vec3 scale = energy_compensation(vec3(f0), e);
      const vec3 response = environment_specular(vec3(f0), f90_from_f0(vec3(f0)), e) * scale;
      const float total = response.x + environment_diffuse_weight(vec3(f0), response, kModelGltf);
      ASSERT_NEAR(total, 1.0f, 1e-3);
    }
  }
}

}  // namespace
}  // namespace velarium::bake
