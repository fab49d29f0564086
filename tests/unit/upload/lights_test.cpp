#include "upload/lights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace velarium::upload {
namespace {

scene::LightInstance light(scene::LightKind kind) {
  scene::LightInstance instance{.light = {.kind = kind, .intensity = 3.0f}};
  return instance;
}

TEST(GpuLights, StandByKindAndKeepTheirOrder) {
  std::vector<scene::LightInstance> instances;
  for (const auto kind : {scene::LightKind::spot, scene::LightKind::point, scene::LightKind::directional,
                          scene::LightKind::point, scene::LightKind::spot})
    instances.push_back(light(kind));
  for (std::size_t i = 0; i < instances.size(); ++i) instances[i].position.x = static_cast<float>(i);
  const auto lights = gpu_lights(instances, glm::dvec3(10.0, 0.0, 0.0), {});
  const LightRanges ranges = light_ranges(lights);
  EXPECT_EQ(ranges.first_point, 1u);
  EXPECT_EQ(ranges.first_spot, 3u);
  EXPECT_EQ(ranges.count, 5u);
  EXPECT_FALSE(any_area_light(lights));
  EXPECT_FALSE(any_projector(lights));
  EXPECT_EQ(lights[1].position_range.x, 1.0f - 10.0f);  // relative to the eye
  EXPECT_EQ(lights[2].position_range.x, 3.0f - 10.0f);
  EXPECT_EQ(lights[3].position_range.x, 0.0f - 10.0f);
}

TEST(GpuLights, KnowTheirSize) {
  auto bulb = light(scene::LightKind::point);
  bulb.light.radius = 0.25f;
  bulb.light.falloff = scene::Falloff::bulb;
  bulb.light.range = 8.0f;
  auto sun = light(scene::LightKind::directional);
  sun.light.angular_radius = 0.5f;
  const auto lights = gpu_lights({bulb, sun}, glm::dvec3(0.0), {});
  EXPECT_NEAR(lights[0].color.w, std::sin(0.5f), 1e-7);
  EXPECT_EQ(lights[1].color.w, 0.25f);
  EXPECT_EQ(lights[1].cone.w, shading::kFalloffBulb);
  EXPECT_TRUE(any_area_light(lights));
  // Lux at 1 m from the surface, and nothing at the cutoff radius.
  EXPECT_NEAR(shading::sample_light(lights[1], glm::vec3(1.25f, 0.0f, 0.0f)).irradiance.x, 3.0f, 1e-5);
  EXPECT_EQ(shading::sample_light(lights[1], glm::vec3(8.0f, 0.0f, 0.0f)).irradiance.x, 0.0f);
  EXPECT_NEAR(shading::sample_light(lights[1], glm::vec3(1.25f, 0.0f, 0.0f)).sine, 0.2f, 1e-6);
  EXPECT_EQ(shading::sample_light(lights[1], glm::vec3(0.1f, 0.0f, 0.0f)).sine, 1.0f);
}

// A product of what a file may hold is beyond fp32; what reaches the shaders leaves room for what they multiply it by.
TEST(GpuLights, AreNeverBrighterThanShadersCanAddUp) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  auto blinding = light(scene::LightKind::point), candle = blinding;
  blinding.light.intensity = kLargest;
  blinding.light.color = {kLargest, 1.0f, 0.0f};
  candle.light.color = {1.0f, 0.5f, 0.25f};
  const auto lights = gpu_lights({blinding, candle}, glm::dvec3(0.0), {});
  const float nearest = shading::sample_light(lights[0], glm::vec3(0.0f)).irradiance.x;
  const float peak = shading::d_ggx(1.0f, shading::kMinAlphaPunctual);
  EXPECT_TRUE(std::isfinite(nearest * peak * static_cast<float>(kMaxLights)));
  EXPECT_GT(nearest, 1e20f);
  EXPECT_EQ(lights[0].color.z, 0.0f);
  EXPECT_EQ(glm::vec3(lights[1].color), glm::vec3(3.0f, 1.5f, 0.75f));
}

TEST(GpuLights, ShareThePicturesTheyThrow) {
  auto first = light(scene::LightKind::spot), second = first, plain = first;
  first.light.projector = {.image = 4, .field_of_view = 1.0f};
  second.light.projector = {.image = 7, .field_of_view = 0.5f};
  const std::vector<scene::Projector> pictures{{.image = 7, .field_of_view = 2.0f}, {.image = 4}};
  const auto lights = gpu_lights({first, second, plain}, glm::dvec3(0.0), pictures);
  EXPECT_EQ(lights[0].projector_layer, 2u);
  EXPECT_EQ(lights[1].projector_layer, 1u);
  EXPECT_EQ(lights[2].projector_layer, 0u);
  EXPECT_NEAR(lights[0].projector.w, std::tan(0.5f), 1e-6);
  EXPECT_TRUE(any_projector(lights));
}

}  // namespace
}  // namespace velarium::upload
