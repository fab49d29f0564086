// Scenes whose radiance is known in closed form. Where the answer is an estimate, it may be off by five of its own
// standard errors: a right tracer fails once in two million runs, and the seeds are fixed.

#include "statistical/tracer_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace velarium::statistical {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kErrors = 5.0;
constexpr double kRounding =
    2e-4;  // of what needs no chance: some dozen operations in fp32, and the cosine over a pixel

// The answer, and that the estimate is sharp enough to mean something.
void expect_radiance(const Traced& traced, double expected, double sharp_to) {
  EXPECT_NEAR(traced.radiance(), expected, kErrors * traced.standard_error() + kRounding * expected);
  EXPECT_LT(traced.standard_error(), sharp_to * expected);
}

scene::Scene one_mesh(scene::Primitive primitive, scene::Material material) {
  scene::SceneBuilder builder("known answer");
  const auto number = builder.add_material(std::move(material));
  builder.place_mesh(builder.add_mesh("mesh", std::move(primitive), number), glm::vec3(0.0f));
  return std::move(builder).take();
}

shading::GpuLight light(const glm::vec3& position, float candela, float radius = 0.0f) {
  return {.position_range = glm::vec4(position, 0.0f),
          .direction = {0.0f, -1.0f, 0.0f, shading::kLightPoint},
          .color = glm::vec4(glm::vec3(candela), radius),
          .cone = {},
          .flags = shading::kLightCastsShadow};
}

// A closed cavity that emits e and reflects a shows e (1 + a + a^2 + ...), wherever one looks. Of flat walls: where
// shading normals lean away from the triangles, a little light falls behind them and is lost.
Tracing cavity(float albedo, float emission) {
  scene::Material m = matt(albedo, emission);
  m.double_sided = true;
  Tracing t{one_mesh(scene::box(glm::vec3(-1.0f), glm::vec3(1.5f)), m), all_around()};
  t.settings.reference.spp = 256;
  return t;
}

TEST(TracerKnownAnswers, CavityGlowsWithTheSumOfAllReflections) {
  expect_radiance(cavity(0.5f, 0.5f).run(), 1.0, 0.003);
}

TEST(TracerKnownAnswers, CavityWithCappedReflectionsGlowsWithTheFirstOnes) {
  Tracing t = cavity(0.5f, 0.5f);
  t.settings.reference.transport = Transport::direct;
  expect_radiance(t.run(), 0.75, 0.002);
  t.settings.reference.transport = Transport::one_bounce;
  expect_radiance(t.run(), 0.875, 0.002);
  t.settings.reference.transport = Transport::full;
  t.settings.reference.max_bounces = 2;
  expect_radiance(t.run(), 0.9375, 0.002);
}

TEST(TracerKnownAnswers, DirectAndIndirectAddUpToTheBeauty) {
  const Traced traced = cavity(0.5f, 0.5f).run();
  const auto beauty = traced.film.beauty(), direct = traced.film.direct(), indirect = traced.film.indirect();
  double direct_sum = 0.0;
  for (std::size_t i = 0; i < beauty.size() / 4; ++i) {
    EXPECT_FLOAT_EQ(beauty[4 * i], direct[3 * i] + indirect[3 * i]);
    direct_sum += static_cast<double>(direct[3 * i]);
  }
  EXPECT_NEAR(direct_sum / static_cast<double>(beauty.size() / 4), 0.75, 0.01);
}

TEST(TracerKnownAnswers, ConvexBodyUnderAnEvenSkyShowsItsAlbedo) {
  Tracing t{one_mesh(scene::uv_sphere(4.0f, 32, 64), matt(0.8f)),
            scene::look_at_camera({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f), {0.0f, 1.0f, 0.0f}, 0.3f)};
  t.environment = constant_environment(1.0f);
  t.settings.reference.spp = 1024;
  expect_radiance(t.run(), 0.8, 0.01);
  t.settings.reference.transport = Transport::direct_env;
  expect_radiance(t.run(), 0.8, 0.01);
  t.settings.reference.transport = Transport::direct;
  EXPECT_EQ(t.run().radiance(), 0.0);
}

// E = I cos / d^2.
TEST(TracerKnownAnswers, PointOverAPlane) {
  Tracing t{one_mesh(square(10.0f, 0.0f, true), matt(0.6f)), point_below(5.0f)};
  t.settings.reference.spp = 4;
  const glm::dvec3 position(1.5, 2.0, 0.0);
  t.lights = {light(glm::vec3(position) - glm::vec3(0.0f, 5.0f, 0.0f), 30.0f)};
  const double d = glm::length(position);
  const double expected = 0.6 / kPi * 30.0 * (position.y / d) / (d * d);
  EXPECT_NEAR(t.run().radiance(), expected, 5e-4 * expected);
}

// E = pi L sin^2(angle) cos = I cos / d^2: as a point, as long as none of the sphere is below the horizon.
TEST(TracerKnownAnswers, SphereOverAPlane) {
  Tracing t{one_mesh(square(10.0f, 0.0f, true), matt(0.6f)), point_below(5.0f)};
  t.settings.reference.spp = 1024;
  const glm::dvec3 position(1.5, 2.0, 0.0);
  t.lights = {light(glm::vec3(position) - glm::vec3(0.0f, 5.0f, 0.0f), 30.0f, 1.2f)};
  const double d = glm::length(position);
  expect_radiance(t.run(), 0.6 / kPi * 30.0 * (position.y / d) / (d * d), 0.002);
}

// Cosine-weighted solid angle of the part of a sphere that is above the horizon, by summing over its disc of
// directions.
double projected_solid_angle(double sine, double elevation_cosine) {
  constexpr int kSteps = 2000;
  const double cap = 1.0 - std::sqrt(1.0 - sine * sine);
  const double up = elevation_cosine, across = std::sqrt(1.0 - up * up);
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = 1.0 - cap * (i + 0.5) / kSteps, radius = std::sqrt(1.0 - cosine * cosine);
    for (int j = 0; j < kSteps; ++j) {
      const double height = cosine * up + radius * std::cos(2.0 * kPi * (j + 0.5) / kSteps) * across;
      sum += std::max(height, 0.0);
    }
  }
  return sum * 2.0 * kPi * cap / (static_cast<double>(kSteps) * kSteps);
}

TEST(TracerKnownAnswers, SphereThatTheHorizonCuts) {
  Tracing t{one_mesh(square(10.0f, 0.0f, true), matt(0.6f)), point_below(5.0f)};
  t.settings.reference.spp = 4096;
  const glm::dvec3 position(2.0, 0.3, 0.0);
  const double d = glm::length(position), radius = 0.8;
  t.lights = {light(glm::vec3(position) - glm::vec3(0.0f, 5.0f, 0.0f), 30.0f, static_cast<float>(radius))};
  const double radiance = 30.0 / (kPi * radius * radius);
  expect_radiance(t.run(), 0.6 / kPi * radiance * projected_solid_angle(radius / d, position.y / d), 0.005);
}

// Form factor of a rectangle a x b at height h, parallel, with one corner above the point [Hottel & Sarofim 1967].
double corner_form_factor(double a, double b, double h) {
  const double x = a / h, y = b / h, p = std::sqrt(1.0 + x * x), q = std::sqrt(1.0 + y * y);
  return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2.0 * kPi);
}

Tracing glowing_ceiling() {
  scene::SceneBuilder builder("ceiling");
  const auto floor = builder.add_material(matt(0.6f)), panel = builder.add_material(matt(0.0f, 3.0f));
  builder.place_mesh(builder.add_mesh("floor", square(10.0f, 0.0f, true), floor), glm::vec3(0.0f));
  builder.place_mesh(builder.add_mesh("panel", square(1.0f, 2.0f, false), panel), glm::vec3(0.0f));
  Tracing t{std::move(builder).take(), point_below(1.5f)};
  t.settings.reference.spp = 1024;
  return t;
}

TEST(TracerKnownAnswers, GlowingPanelOverAPlane) {
  expect_radiance(glowing_ceiling().run(), 0.6 * 3.0 * 4.0 * corner_form_factor(1.0, 1.0, 2.0), 0.003);
}

TEST(TracerKnownAnswers, BacksOfPanelsStayDarkUnlessDoubleSided) {
  Tracing t = glowing_ceiling();
  const auto flip = [&](scene::Primitive& p) {
    std::swap(p.indices[1], p.indices[2]), std::swap(p.indices[4], p.indices[5]);
  };
  flip(t.scene.primitives[1]);
  EXPECT_EQ(t.run().radiance(), 0.0);
  t.scene.materials[1].double_sided = true;
  expect_radiance(t.run(), 0.6 * 3.0 * 4.0 * corner_form_factor(1.0, 1.0, 2.0), 0.003);
}

// A sheet between the panel and the floor.
Tracing shaded_ceiling(scene::Material sheet) {
  Tracing t = glowing_ceiling();
  scene::SceneBuilder builder("shaded ceiling");
  const auto floor = builder.add_material(t.scene.materials[0]), panel = builder.add_material(t.scene.materials[1]);
  const auto middle = builder.add_material(std::move(sheet));
  builder.place_mesh(builder.add_mesh("floor", square(10.0f, 0.0f, true), floor), glm::vec3(0.0f));
  builder.place_mesh(builder.add_mesh("panel", square(1.0f, 2.0f, false), panel), glm::vec3(0.0f));
  builder.place_mesh(builder.add_mesh("sheet", square(5.0f, 1.75f, true), middle), glm::vec3(0.0f));
  t.scene = std::move(builder).take();
  t.settings.reference.transport = Transport::direct;
  return t;
}

TEST(TracerKnownAnswers, ShadowsOfBlendedSurfacesAreAsDeepAsTheirAlpha) {
  scene::Material sheet = matt(0.0f);
  sheet.base_color.w = 0.25f;
  sheet.alpha_mode = scene::AlphaMode::blend;
  const double open = 0.6 * 3.0 * 4.0 * corner_form_factor(1.0, 1.0, 2.0);
  expect_radiance(shaded_ceiling(sheet).run(), 0.75 * open, 0.005);
}

// Green passes a red sheet of alpha 1/2 by 1/2 (1/2 + 1/2 0.04 / 1.04), whether the panel is aimed at or found.
TEST(TracerKnownAnswers, ColouredBlendedSurfacesDyeTheLightThatPasses) {
  scene::Material sheet = matt(0.0f);
  sheet.base_color = {1.0f, 0.0f, 0.0f, 0.5f};
  sheet.alpha_mode = scene::AlphaMode::blend;
  sheet.double_sided = true;
  const double passed = 0.259615;
  Tracing t = shaded_ceiling(sheet);
  expect_radiance(t.run(), passed * 0.6 * 3.0 * 4.0 * corner_form_factor(1.0, 1.0, 2.0), 0.005);
  // A small bulb between the sheet and the panel.
  t.scene.materials[1].emissive = glm::vec3(0.0f);
  t.lights = {light({0.0f, 1.9f - 1.5f, 0.0f}, 30.0f, 0.1f)};
  expect_radiance(t.run(), passed * 0.6 / kPi * 30.0 / (1.9 * 1.9), 0.01);
}

TEST(TracerKnownAnswers, MaskedSurfacesStopAllLightOrNone) {
  scene::Material sheet = matt(0.0f);
  sheet.alpha_mode = scene::AlphaMode::mask;
  sheet.base_color.w = 0.49f;
  const double open = 0.6 * 3.0 * 4.0 * corner_form_factor(1.0, 1.0, 2.0);
  expect_radiance(shaded_ceiling(sheet).run(), open, 0.003);
  sheet.base_color.w = 0.5f;
  EXPECT_EQ(shaded_ceiling(sheet).run().radiance(), 0.0);
}

TEST(TracerKnownAnswers, WithoutShadowsNothingStandsInTheWay) {
  Tracing t = shaded_ceiling(matt(0.0f));
  EXPECT_EQ(t.run().radiance(), 0.0);
  t.settings.reference.shadows = false;
  expect_radiance(t.run(), 0.6 * 3.0 * 4.0 * corner_form_factor(1.0, 1.0, 2.0), 0.003);
  t.scene.materials[1].emissive = glm::vec3(0.0f);
  t.environment = constant_environment(2.0f);
  t.settings.reference.transport = Transport::direct_env;
  expect_radiance(t.run(), 0.6 * 2.0, 0.01);
}

}  // namespace
}  // namespace velarium::statistical
