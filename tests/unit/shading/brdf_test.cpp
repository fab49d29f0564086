#include <gtest/gtest.h>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

Surface make_surface(vec3 albedo, vec3 f0) {
  return {vec3(0.0f, 0.0f, 1.0f), albedo, f0, 0.5f, 1.0f, 0.0f, vec2(0.0f), kClassStandard};
}

vec3 direction_at(double theta, double phi) {
  return {static_cast<float>(std::sin(theta) * std::cos(phi)), static_cast<float>(std::sin(theta) * std::sin(phi)),
          static_cast<float>(std::cos(theta))};
}

// Integral over the hemisphere of evaluate_brdf: what a uniform environment sends towards wo.
double reflected_share(const Surface& s, float alpha, vec3 wo, uint model) {
  constexpr int kRings = 600, kSectors = 600;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double c = (i + 0.5) / kRings;
    for (int j = 0; j < kSectors; ++j) {
      const vec3 wi = direction_at(std::acos(c), 2.0 * kPiExact * (j + 0.5) / kSectors);
      sum += evaluate_brdf(s, alpha, wo, wi, vec3(1.0f), model).y;
    }
  }
  return sum * 2.0 * kPiExact / (kRings * kSectors);
}

TEST(Surface, MetalRoughBecomesAlbedoAndReflectance) {
  const vec3 base{0.8f, 0.4f, 0.2f}, up{0.0f, 0.0f, 1.0f};
  const Surface plastic = surface_from_metal_rough(base, 0.0f, 0.5f, 0.04f, vec3(1.0f), up, 0.7f);
  EXPECT_EQ(plastic.albedo, base);
  EXPECT_EQ(plastic.f0, vec3(0.04f));
  EXPECT_EQ(plastic.occlusion, 0.7f);
  EXPECT_NEAR(alpha_from_smoothness(plastic.smoothness), 0.25f, 1e-6);
  const Surface metal = surface_from_metal_rough(base, 1.0f, 1.0f, 0.04f, vec3(1.0f), up, 1.0f);
  EXPECT_EQ(metal.albedo, vec3(0.0f));
  EXPECT_EQ(metal.f0, base);
  EXPECT_EQ(metal.smoothness, 0.0f);
  const Surface tinted = surface_from_metal_rough(base, 0.0f, 1.0f, 0.5f, vec3(4.0f, 1.0f, 0.0f), up, 1.0f);
  EXPECT_EQ(tinted.f0, vec3(1.0f, 0.5f, 0.0f));
}

TEST(Surface, ReflectanceOfDielectrics) {
  EXPECT_NEAR(dielectric_f0_from_ior(1.5f), 0.04f, 1e-7);
  EXPECT_NEAR(dielectric_f0_from_ior(1.33f), 0.020059f, 1e-6);
  EXPECT_EQ(dielectric_f0_from_ior(1.0f), 0.0f);
  EXPECT_EQ(dielectric_f0_from_ior(0.0f), 1.0f);
}

TEST(Brdf, IsReciprocal) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Surface s = make_surface(random.color(), random.color());
    const vec3 a = random.hemisphere_direction(), b = random.hemisphere_direction();
    if (a.z < 0.05f || b.z < 0.05f) continue;
    const float alpha = random.uniform(0.05f, 1.0f);
    for (const uint model : {kModelGltf, kModelRyse, kModelBlinnPhong}) {
      const vec3 forth = evaluate_brdf(s, alpha, a, b, vec3(1.0f), model) / b.z;
      const vec3 back = evaluate_brdf(s, alpha, b, a, vec3(1.0f), model) / a.z;
      ASSERT_NEAR(forth.x / back.x, 1.0f, 2e-3);
    }
  }
}

// Light just above the horizon, the eye just below it: their half vector is all but -n, where no microfacets look.
TEST(Brdf, HasNoHighlightBelowTheSurface) {
  const Surface s = make_surface(vec3(0.0f), vec3(1.0f));
  const vec3 wo = direction_at(radians(96.0), 0.0), wi = direction_at(radians(89.0), kPiExact);
  EXPECT_GT(dot(half_vector(wo, wi), -s.normal_ws), 0.9f);
  for (const uint model : {kModelGltf, kModelRyse, kModelBlinnPhong})
    EXPECT_LT(evaluate_brdf(s, 0.1f, wo, wi, vec3(1.0f), model).x, 0.05f) << model;
}

TEST(Brdf, IsBlackBelowTheHorizonAndFiniteEverywhere) {
  const Surface s = make_surface(vec3(1.0f), vec3(1.0f));
  const vec3 wo = normalize(vec3(0.3f, 0.1f, 0.8f));
  EXPECT_EQ(evaluate_brdf(s, 0.1f, wo, vec3(0.0f, 0.6f, -0.8f), vec3(1.0f), kModelGltf), vec3(0.0f));
  EXPECT_EQ(evaluate_brdf(s, 0.1f, wo, vec3(1.0f, 0.0f, 0.0f), vec3(1.0f), kModelGltf), vec3(0.0f));
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const vec3 a = random.direction(), b = i % 4 == 0 ? -a : random.direction();
    for (const uint model : {kModelGltf, kModelRyse, kModelBlinnPhong}) {
      const vec3 f = evaluate_brdf(s, kMinAlpha, a, b, vec3(1.0f), model);
      ASSERT_TRUE(std::isfinite(f.x) && f.x >= 0.0f);
    }
  }
}

TEST(Brdf, DiffuseAloneIsTheAlbedo) {
  const Surface s = make_surface(vec3(0.5f), vec3(0.0f));
  for (const double angle : {0.0, 45.0, 80.0}) {
    EXPECT_NEAR(reflected_share(s, 0.3f, direction_at(radians(angle), 0.0), kModelGltf), 0.5, 1e-3) << angle;
  }
}

struct AlbedoRow {
  double n_dot_v, smith, ryse;
};

// Directional albedo of a white metal of alpha 1.
TEST(Brdf, WhiteMetalReflectsTheTabledShare) {
  const Surface metal = make_surface(vec3(0.0f), vec3(1.0f));
  for (const AlbedoRow& row : {AlbedoRow{0.25, 0.5969, 0.2987}, AlbedoRow{0.5, 0.4507, 0.2862},
                               AlbedoRow{0.75, 0.3645, 0.2747}, AlbedoRow{1.0, 0.3069, 0.2640}}) {
    const vec3 wo = direction_at(std::acos(row.n_dot_v), 0.4);
    EXPECT_NEAR(reflected_share(metal, 1.0f, wo, kModelGltf), row.smith, 2e-3) << row.n_dot_v;
    EXPECT_NEAR(reflected_share(metal, 1.0f, wo, kModelRyse), row.ryse, 2e-3) << row.n_dot_v;
  }
}

// (E0, E1) as an environment table would give them, by the same numbers as above.
TEST(EnvironmentBrdf, WhiteFurnaceCloses) {
  for (const vec2 env : {vec2(0.4058f, 0.9003f), vec2(0.0109f, 0.5976f), vec2(0.7736f, 0.9999f), vec2(0.0f, 0.3069f)}) {
    const vec3 plastic{0.04f};
    const vec3 response = environment_specular(plastic, f90_from_f0(plastic), env) * energy_compensation(plastic, env);
    const float diffuse_weight = environment_diffuse_weight(plastic, response, kModelGltf);
    EXPECT_NEAR(response.x + diffuse_weight, 1.0f, 1e-6);
    const vec3 white{1.0f};
    const vec3 metal = environment_specular(white, 1.0f, env) * energy_compensation(white, env);
    EXPECT_NEAR(metal.x, 1.0f, 1e-6);
    EXPECT_NEAR(environment_diffuse_weight(white, metal, kModelGltf), 0.0f, 1e-6);
  }
}

TEST(EnvironmentBrdf, InterpolatesBetweenItsEnds) {
  const vec2 env{0.2f, 0.9f};
  EXPECT_EQ(environment_specular(vec3(0.0f), 1.0f, env), vec3(0.2f));
  EXPECT_NEAR(environment_specular(vec3(1.0f), 1.0f, env).y, 0.9f, 1e-6);
  EXPECT_EQ(environment_specular(vec3(0.0f), 0.0f, env), vec3(0.0f));
  EXPECT_NEAR(environment_diffuse_weight(vec3(0.5f), vec3(0.9f), kModelRyse), 0.5f, 1e-6);
}

}  // namespace
}  // namespace velarium::shading
