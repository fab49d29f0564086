#include <gtest/gtest.h>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

TEST(Attenuation, BulbFalloffIsTheTabledOne) {
  const auto from_surface = [](float d, float b) { return bulb_falloff(d + b, b); };
  EXPECT_NEAR(from_surface(0.0f, 0.05f), 441.0f, 441e-5);
  EXPECT_NEAR(from_surface(0.5f, 0.05f), 3.6446f, 5e-5);
  EXPECT_NEAR(from_surface(1.0f, 0.05f), 1.0f, 1e-5);
  EXPECT_NEAR(from_surface(2.0f, 0.05f), 0.26234f, 5e-6);
  EXPECT_NEAR(from_surface(10.0f, 0.05f), 0.010916f, 5e-7);
  EXPECT_NEAR(from_surface(0.0f, 0.25f), 25.0f, 25e-5);
  EXPECT_NEAR(from_surface(2.0f, 0.25f), 0.30864f, 5e-6);
  EXPECT_NEAR(from_surface(0.0f, 1.0f), 4.0f, 4e-5);
  EXPECT_NEAR(from_surface(2.0f, 1.0f), 0.4444f, 5e-5);
  EXPECT_EQ(bulb_falloff(0.01f, 0.25f), bulb_falloff(0.25f, 0.25f));  // inside the bulb
}

// Irradiance of a uniform sphere facing the receiver, by integration over the cone that it fills.
TEST(Attenuation, BulbFalloffIsThatOfASphere) {
  const double radius = 0.25, distance = 1.25, cos_max = std::sqrt(1.0 - std::pow(radius / distance, 2));
  double sum = 0.0;
  for (int i = 0; i < 400; ++i) sum += cos_max + (1.0 - cos_max) * (i + 0.5) / 400.0;
  const double irradiance = sum / 400.0 * 2.0 * (1.0 - cos_max);  // over pi times radiance
  EXPECT_NEAR(irradiance, 0.040000, 1e-6);
  EXPECT_NEAR(bulb_falloff(1.25f, 0.25f) / bulb_falloff(0.25f, 0.25f), irradiance, 1e-6);
}

TEST(Attenuation, CutoffFadesOverTheLastFifth) {
  EXPECT_EQ(cutoff_fade(3.0f, 10.0f), 1.0f);
  EXPECT_NEAR(cutoff_fade(8.0f, 10.0f), 1.0f, 1e-6);
  EXPECT_NEAR(cutoff_fade(9.0f, 10.0f), 0.5f, 1e-6);
  EXPECT_NEAR(cutoff_fade(9.5f, 10.0f), 0.25f, 1e-6);
  EXPECT_EQ(cutoff_fade(10.0f, 10.0f), 0.0f);
  EXPECT_NEAR(bulb_attenuation(9.0f, 1.0f, 10.0f), 0.25f * 4.0f / 81.0f, 1e-6);
}

TEST(Attenuation, RangeWindow) {
  EXPECT_NEAR(range_attenuation(2.0f, 0.0f), 0.25f, 1e-7);
  EXPECT_NEAR(range_attenuation(5.0f, 10.0f), (1.0f - 1.0f / 16.0f) / 25.0f, 1e-7);
  EXPECT_EQ(range_attenuation(10.0f, 10.0f), 0.0f);
  EXPECT_EQ(range_attenuation(11.0f, 10.0f), 0.0f);
  EXPECT_NEAR(range_attenuation(0.0f, 10.0f), 1e6f, 1.0f);
}

TEST(Attenuation, SpotCones) {
  const vec2 so = spot_scale_offset(0.3f, 0.6f);
  EXPECT_NEAR(spot_attenuation(std::cos(0.29f), so), 1.0f, 1e-6);
  EXPECT_EQ(spot_attenuation(std::cos(0.61f), so), 0.0f);
  EXPECT_NEAR(spot_attenuation(0.5f * (std::cos(0.3f) + std::cos(0.6f)), so), 0.25f, 1e-5);
  const vec2 hard = spot_scale_offset(0.5f, 0.5f);
  EXPECT_EQ(spot_attenuation(std::cos(0.51f), hard), 0.0f);
  EXPECT_EQ(spot_attenuation(std::cos(0.4f), hard), 1.0f);
  // However narrow, the axis has all of the light.
  for (const float outer : {0.04f, 0.01f, 0.002f})
    EXPECT_EQ(spot_attenuation(1.0f, spot_scale_offset(0.0f, outer)), 1.0f) << outer;
}

GpuLight light(float kind, float range) {
  const vec2 so = spot_scale_offset(0.0f, 0.5f);
  return {vec4(0, 3, 0, range), vec4(0, -1, 0, kind), vec4(2, 4, 6, 0), vec4(so.x, so.y, std::cos(0.5f), 0)};
}

TEST(Lights, Directional) {
  const LightSample s = sample_light(light(kLightDirectional, 0.0f), vec3(100.0f));
  EXPECT_EQ(s.wi, vec3(0, 1, 0));
  EXPECT_EQ(s.irradiance, vec3(2, 4, 6));
  EXPECT_EQ(light_cull_radius(light(kLightDirectional, 0.0f)), kUnboundedRadius);
}

TEST(Lights, Point) {
  const LightSample s = sample_light(light(kLightPoint, 0.0f), vec3(0, 1, 0));
  EXPECT_EQ(s.wi, vec3(0, 1, 0));
  EXPECT_NEAR(s.irradiance.y, 1.0f, 1e-6);
  EXPECT_EQ(sample_light(light(kLightPoint, 2.0f), vec3(0, 1, 0)).irradiance, vec3(0.0f));
  const LightSample at_light = sample_light(light(kLightPoint, 0.0f), vec3(0, 3, 0));
  EXPECT_NEAR(length(at_light.wi), 1.0f, 1e-6);
  EXPECT_TRUE(std::isfinite(at_light.irradiance.z));
  EXPECT_EQ(light_cull_radius(light(kLightPoint, 0.0f)), kUnboundedRadius);
  EXPECT_EQ(light_cull_radius(light(kLightPoint, 2.0f)), 2.0f);
}

TEST(Lights, Spot) {
  const GpuLight spot = light(kLightSpot, 0.0f);
  EXPECT_NEAR(sample_light(spot, vec3(0, 1, 0)).irradiance.x, 0.5f, 1e-6);
  EXPECT_EQ(sample_light(spot, vec3(2, 1, 0)).irradiance, vec3(0.0f));
  EXPECT_EQ(sample_light(spot, vec3(0, 5, 0)).irradiance, vec3(0.0f));
  EXPECT_EQ(sizeof(GpuLight), 96u);
}

}  // namespace
}  // namespace velarium::shading
