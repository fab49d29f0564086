#include <gtest/gtest.h>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

const vec3 kUp(0.0f, 1.0f, 0.0f);

// A sphere about this centre.
GpuAmbientLight sphere(const vec3& color, const vec3& center = vec3(0.0f), float range = 2.0f) {
  const float scale = 1.0f / range;
  return {.x = vec4(scale, 0.0f, 0.0f, center.x),
          .y = vec4(0.0f, scale, 0.0f, center.y),
          .z = vec4(0.0f, 0.0f, scale, center.z),
          .color = vec4(color, 0.0f)};
}

vec3 factor_at_center(const vec3& color) {
  return ambient_light_factor(sphere(color), vec3(0.0f), kUp, 1.0f);
}

// (1 - D^2 / r^2)^2
TEST(AmbientLight, FadesToNothingAtItsRange) {
  const GpuAmbientLight light = sphere(vec3(0.5f), vec3(10.0f, 0.0f, -3.0f), 2.0f);
  const auto at = [&](float distance) { return ambient_attenuation(light, vec3(10.0f, distance, -3.0f)); };
  EXPECT_EQ(at(0.0f), 1.0f);
  EXPECT_FLOAT_EQ(at(1.0f), 0.5625f);
  EXPECT_FLOAT_EQ(at(1.5f), 0.19140625f);
  EXPECT_EQ(at(2.0f), 0.0f);
  EXPECT_EQ(at(2.5f), 0.0f);
  EXPECT_EQ(at(1e18f), 0.0f);
  // No slope at the end: what is left of the last hundredth is its square.
  EXPECT_NEAR(at(2.0f * 0.99f), 4e-4f, 5e-6f);
}

// Extents of 1 m, 2 m and 4 m, turned by a quarter about y.
TEST(AmbientLight, IsAnEllipsoidWhereItsNodeIsScaled) {
  const GpuAmbientLight light{.x = vec4(0.0f, 0.0f, -1.0f, 0.0f),
                              .y = vec4(0.0f, 0.5f, 0.0f, 0.0f),
                              .z = vec4(0.25f, 0.0f, 0.0f, 0.0f),
                              .color = vec4(0.0f)};
  EXPECT_FLOAT_EQ(ambient_attenuation(light, vec3(0.0f, 0.0f, 0.5f)), 0.5625f);
  EXPECT_FLOAT_EQ(ambient_attenuation(light, vec3(0.0f, -1.0f, 0.0f)), 0.5625f);
  EXPECT_FLOAT_EQ(ambient_attenuation(light, vec3(2.0f, 0.0f, 0.0f)), 0.5625f);
  EXPECT_EQ(ambient_attenuation(light, vec3(0.0f, 0.0f, 1.0f)), 0.0f);
}

TEST(AmbientLight, OfColor1IsTheIdentityToTheBit) {
  for (const float height : {0.0f, 0.3f, 1.1f, 1.999f, 3.0f})
    for (const float occlusion : {0.0f, 0.4f, 1.0f})
      EXPECT_EQ(ambient_light_factor(sphere(vec3(1.0f)), vec3(0.1f, height, 0.7f), kUp, occlusion), vec3(1.0f));
}

TEST(AmbientLight, OfHalfTheColorHalvesAtItsCenter) {
  EXPECT_EQ(factor_at_center(vec3(0.5f)), vec3(0.5f));
  EXPECT_EQ(factor_at_center(vec3(0.0f, 0.25f, 1.0f)), vec3(0.0f, 0.25f, 1.0f));
}

// What darkens has no direction: whichever way a surface faces, and however hidden it lies, the same is left.
TEST(AmbientLight, DarkensWhicheverWayASurfaceFaces) {
  const GpuAmbientLight light = sphere(vec3(0.5f));
  const vec3 place(0.0f, -1.0f, 0.0f);
  const vec3 expected(1.0f - 0.5f * 0.5625f);
  for (const vec3& normal : {kUp, -kUp, vec3(1.0f, 0.0f, 0.0f)})
    for (const float occlusion : {0.0f, 1.0f}) {
      const vec3 factor = ambient_light_factor(light, place, normal, occlusion);
      for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(factor[c], expected[c]);
    }
}

// What brightens does so by n.l towards the centre, and in crannies by three tenths.
TEST(AmbientLight, BrightensWhatFacesItsCenter) {
  const GpuAmbientLight light = sphere(vec3(3.0f));
  const vec3 below(0.0f, -1.0f, 0.0f);
  const auto at = [&](const vec3& normal, float occlusion) {
    return ambient_light_factor(light, below, normal, occlusion).x;
  };
  EXPECT_FLOAT_EQ(at(kUp, 1.0f), 1.0f + 2.0f * 0.5625f);
  EXPECT_FLOAT_EQ(at(vec3(0.8f, 0.6f, 0.0f), 1.0f), 1.0f + 2.0f * 0.5625f * 0.6f);
  EXPECT_EQ(at(-kUp, 1.0f), 1.0f);
  EXPECT_FLOAT_EQ(at(kUp, 0.0f), 1.0f + 2.0f * 0.5625f * 0.3f);
  EXPECT_FLOAT_EQ(at(kUp, 0.5f), 1.0f + 2.0f * 0.5625f * 0.65f);
}

// A channel that passes 1 takes no other along: the factor has no jump.
TEST(AmbientLight, ChannelsAskForThemselves) {
  const vec3 place(0.0f, -1.0f, 0.0f);
  const vec3 under = ambient_light_factor(sphere(vec3(1.0f, 0.3f, 0.3f)), place, -kUp, 1.0f);
  const vec3 over = ambient_light_factor(sphere(vec3(1.0001f, 0.3f, 0.3f)), place, -kUp, 1.0f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(under[c], over[c], 1e-4f);
  EXPECT_LT(over.y, 0.7f);
}

// Two factors to the bit; of more the products round.
TEST(AmbientLight, OrderDoesNotMatter) {
  const vec3 place(0.3f, -0.4f, 0.2f);
  const vec3 a = ambient_light_factor(sphere(vec3(0.5f, 2.0f, 0.9f)), place, kUp, 0.7f);
  const vec3 b = ambient_light_factor(sphere(vec3(3.0f, 0.1f, 1.0f), vec3(0.5f), 3.0f), place, kUp, 0.7f);
  const vec3 c = ambient_light_factor(sphere(vec3(0.7f), vec3(0.0f, 1.0f, 0.0f), 5.0f), place, kUp, 0.7f);
  EXPECT_EQ(a * b, b * a);
  const vec3 forth = a * b * c, back = c * b * a;
  for (int channel = 0; channel < 3; ++channel) EXPECT_FLOAT_EQ(forth[channel], back[channel]);
}

}  // namespace
}  // namespace velarium::shading
