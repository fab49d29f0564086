// The white furnace, traced: in surroundings of radiance 1, spheres of builtin:furnace that absorb nothing vanish.
//
// Those of full reflectance do. White paint and half metals show what their reflectance makes of an even light, which
// glTF's weights of diffuse and specular light do not keep at 1: there the tracer is held to the integral of it.

#include "statistical/tracer_scene.hpp"

#include "bake/environment_brdf.hpp"
#include "scene/builtin.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace velarium::statistical {
namespace {

using namespace shading;

constexpr double kErrors = 5.0;  // standard errors, of estimates
// The table of what one reflection keeps: its own 1e-3, and as much between its places.
constexpr double kTableError = 2e-3;
constexpr float kSphereRadius = 0.45f;  // on a grid of one metre

// From above; from left to right, perceptual roughness is 0, 0.2 .. 1.
enum Row { kMetal, kFullReflectance, kHalfMetal, kPaint };
constexpr int kColumns = 6;

float roughness_of(int column) {
  return static_cast<float>(column) / (kColumns - 1);
}

// A spot of a sphere where n.v has this value, `half_width` metres to each side.
Tracing spot_on(Row row, int column, float n_dot_v, float half_width) {
  Tracing t{.scene = scene::builtin_scene("furnace"), .camera = {}};
  const float beside = kSphereRadius * std::sqrt(1.0f - n_dot_v * n_dot_v);
  const glm::vec3 target(static_cast<float>(column) - 2.5f + beside, 1.5f - static_cast<float>(row), 0.0f);
  t.camera = scene::look_at_camera(target + glm::vec3(0.0f, 0.0f, 2.0f), target, {0.0f, 1.0f, 0.0f}, 1.0f);
  t.camera.camera.kind = scene::Camera::Kind::orthographic;
  t.camera.camera.half_size = glm::vec2(half_width);
  t.camera.camera.z_near = 0.0f;
  t.camera.camera.z_far = 4.0f;
  t.environment = constant_environment(1.0f);
  t.settings.reference.spp = 1024;
  t.settings.reference.transport = Transport::direct_env;
  t.settings.reference.shadows = false;  // each sphere alone
  return t;
}

void expect_radiance(const Traced& traced, double expected, double sharp_to) {
  EXPECT_NEAR(traced.radiance(), expected, kErrors * traced.standard_error() + kTableError);
  EXPECT_LT(traced.standard_error(), sharp_to);
}

TEST(TracerFurnace, FullReflectanceVanishes) {
  for (const Row row : {kMetal, kFullReflectance})
    for (int column = 0; column < kColumns; ++column) {
      SCOPED_TRACE(testing::Message() << "row " << row << ", column " << column);
      expect_radiance(spot_on(row, column, 1.0f, 0.6f * kSphereRadius).run(), 1.0, 4e-3);
    }
}

// Of a uniform light, the rough metal's lobe alone keeps 1 - mu ln((1 + mu) / mu): see tests/furnace.
TEST(TracerFurnace, SingleScatteringLosesWhatTheIntegralSays) {
  Tracing t = spot_on(kMetal, kColumns - 1, 1.0f, 0.02f * kSphereRadius);
  t.settings.lighting.multi_scatter = false;
  expect_radiance(t.run(), 1.0 - std::log(2.0), 3e-3);
}

// Light of radiance 1 from everywhere, towards an eye at this cosine, with what single scattering loses given back.
double reflected_share(float metallic, float perceptual_roughness, float n_dot_v) {
  constexpr std::uint32_t kRings = 400;
  const Surface s = surface_from_metal_rough(vec3(1.0f), metallic, perceptual_roughness, 0.04f, vec3(1.0f),
                                             vec3(0.0f, 0.0f, 1.0f), 1.0f);
  const float alpha = alpha_from_smoothness(s.smoothness);
  const vec3 wo(std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v);
  const vec3 scale = energy_compensation(s.f0, bake::integrate_environment_brdf(n_dot_v, alpha, kModelGltf, kRings));
  double sum = 0.0;
  for (std::uint32_t i = 0; i < kRings; ++i)
    for (std::uint32_t j = 0; j < kRings; ++j) {
      const float z = (static_cast<float>(i) + 0.5f) / kRings, r = std::sqrt(1.0f - z * z);
      const float azimuth = kTwoPi * (static_cast<float>(j) + 0.5f) / kRings;
      sum += static_cast<double>(
          evaluate_brdf(s, alpha, wo, {r * std::cos(azimuth), r * std::sin(azimuth), z}, scale, kModelGltf).y);
    }
  return sum * static_cast<double>(kTwoPi) / (kRings * kRings);
}

TEST(TracerFurnace, PaintAndHalfMetalsShowTheirIntegral) {
  for (const Row row : {kHalfMetal, kPaint})
    for (const int column : {3, 5})
      for (const float n_dot_v : {1.0f, 0.5f}) {
        SCOPED_TRACE(testing::Message() << "row " << row << ", column " << column << ", n.v " << n_dot_v);
        expect_radiance(spot_on(row, column, n_dot_v, 0.02f * kSphereRadius).run(),
                        reflected_share(row == kHalfMetal ? 0.5f : 0.0f, roughness_of(column), n_dot_v), 4e-3);
      }
}

}  // namespace
}  // namespace velarium::statistical
