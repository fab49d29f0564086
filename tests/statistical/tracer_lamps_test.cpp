// Lights of every kind over a plane, whose radiance is known in closed form. Estimates may be off by five of their own
// standard errors.

#include "statistical/tracer_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace velarium::statistical {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kErrors = 5.0, kRounding = 5e-4;
constexpr float kHeight = 5.0f;  // of the camera above the plane y = 0

void expect_radiance(const Tracing& tracing, double expected) {
  const Traced traced = tracing.run();
  EXPECT_NEAR(traced.radiance(), expected, kErrors * traced.standard_error() + kRounding * expected);
  EXPECT_LT(traced.standard_error(), 0.01 * expected);
}

// A plane of albedo 0.6, with a sheet above it where asked for.
Tracing plane(bool covered = false) {
  scene::SceneBuilder builder("lamps");
  const auto floor = builder.add_material(matt(0.6f)), sheet = builder.add_material(matt(0.0f));
  builder.place_mesh(builder.add_mesh("floor", square(10.0f, 0.0f, true), floor), glm::vec3(0.0f));
  if (covered) builder.place_mesh(builder.add_mesh("sheet", square(9.0f, 0.5f, false), sheet), glm::vec3(0.0f));
  Tracing t{std::move(builder).take(), point_below(covered ? 0.4f : kHeight)};
  t.settings.reference.transport = Transport::direct;
  t.settings.reference.spp = 1024;
  return t;
}

// Casts shadows; its place is in the scene's axes, a camera at `eye_height` above the origin sees it.
shading::GpuLight light(float kind, const glm::vec3& position, const glm::vec3& direction, float size,
                        float eye_height = kHeight) {
  shading::GpuLight l{};
  l.position_range = glm::vec4(position - glm::vec3(0.0f, eye_height, 0.0f), 0.0f);
  l.direction = glm::vec4(glm::normalize(direction), kind);
  l.color = glm::vec4(glm::vec3(10.0f), size);
  l.flags = shading::kLightCastsShadow;
  return l;
}

const glm::vec3 kDown(0.0f, -1.0f, 0.0f);

// A disc that the horizon does not cut lights a plane as its middle alone would.
TEST(TracerLamps, DiscAtTheSky) {
  Tracing t = plane();
  for (const float sine : {0.0f, 0.00465f, 0.5f}) {
    t.lights = {light(shading::kLightDirectional, {}, {0.6f, -0.8f, 0.0f}, sine)};
    expect_radiance(t, 0.6 / kPi * 10.0 * 0.8);
  }
}

// Half of the disc is up: cosines over a half disc, 2 sin^3 / 3 for small ones, over its whole pi sin^2.
TEST(TracerLamps, DiscThatTheHorizonCuts) {
  Tracing t = plane();
  const double sine = 0.05;
  t.lights = {light(shading::kLightDirectional, {}, {1.0f, 0.0f, 0.0f}, static_cast<float>(sine))};
  t.settings.reference.spp = 4096;
  expect_radiance(t, 0.6 / kPi * 10.0 / (kPi * sine * sine) * (2.0 / 3.0 * sine * sine * sine));
}

// Lux at 1 m from the surface; half of the fade, squared, at 0.9 of the cutoff radius.
TEST(TracerLamps, BulbsFallOffFromTheirSurface) {
  Tracing t = plane();
  shading::GpuLight bulb = light(shading::kLightPoint, {0.0f, 1.25f, 0.0f}, kDown, 0.25f);
  bulb.cone.w = shading::kFalloffBulb;
  t.lights = {bulb};
  expect_radiance(t, 0.6 / kPi * 10.0);
  bulb.position_range.w = 1.25f / 0.9f;
  t.lights = {bulb};
  expect_radiance(t, 0.6 / kPi * 10.0 * 0.25);
}

TEST(TracerLamps, NothingHidesLampsThatCastNoShadows) {
  constexpr float kLow = 0.4f;
  Tracing t = plane(true);
  const glm::vec3 above(0.0f, 2.0f, 0.0f);
  for (const float size : {0.0f, 0.5f}) {
    shading::GpuLight point = light(shading::kLightPoint, above, kDown, size, kLow);
    t.lights = {point};
    EXPECT_EQ(t.run().radiance(), 0.0) << size;
    point.flags = 0;
    t.lights = {point};
    expect_radiance(t, 0.6 / kPi * 10.0 / 4.0);
    shading::GpuLight disc = light(shading::kLightDirectional, {}, kDown, size, kLow);
    t.lights = {disc};
    EXPECT_EQ(t.run().radiance(), 0.0) << size;
    disc.flags = 0;
    t.lights = {disc};
    expect_radiance(t, 0.6 / kPi * 10.0);
  }
}

// A spot looks down, its right is +X: it throws the left, red half of its picture onto the side of -X.
TEST(TracerLamps, SpotsThrowTheirPictures) {
  Tracing t = plane();
  t.projectors = {{.name = {},
                   .width = 4,
                   .height = 1,
                   .rgba = {255, 0, 0, 255, 255, 0, 0, 255,  //
                            0, 255, 0, 255, 0, 255, 0, 255}}};
  for (const float x : {-0.5f, 0.5f}) {
    shading::GpuLight spot = light(shading::kLightSpot, {x, 2.0f, 0.0f}, kDown, 0.0f);
    spot.cone = {0.0f, 1.0f, 0.0f, shading::kFalloffInverseSquare};
    spot.projector = {1.0f, 0.0f, 0.0f, 1.0f};
    spot.projector_layer = 1;
    t.lights = {spot};
    const double d2 = 4.0 + static_cast<double>(x * x);
    // The plane's middle lies on the other side of the spot's axis; radiance() is of green.
    EXPECT_NEAR(t.run().radiance(), x < 0.0f ? 0.6 / kPi * 10.0 * 2.0 / (d2 * std::sqrt(d2)) : 0.0, 1e-3);
  }
}

TEST(TracerLamps, PicturesEndAtTheirBorders) {
  Tracing t = plane();
  t.projectors = {{.name = {}, .width = 1, .height = 1, .rgba = {255, 255, 255, 255}}};
  shading::GpuLight spot = light(shading::kLightSpot, {2.1f, 2.0f, 0.0f}, kDown, 0.0f);
  spot.cone = {0.0f, 1.0f, 0.0f, shading::kFalloffInverseSquare};
  spot.projector = {1.0f, 0.0f, 0.0f, 1.0f};
  spot.projector_layer = 1;
  t.lights = {spot};
  EXPECT_EQ(t.run().radiance(), 0.0);
  t.lights[0].position_range.x = 1.9f;
  EXPECT_GT(t.run().radiance(), 0.1);
}

}  // namespace
}  // namespace velarium::statistical
