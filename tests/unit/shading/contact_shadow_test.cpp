#include <gtest/gtest.h>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

TEST(ContactShadow, APixelIsAsHighAsThePictureOverItsLines) {
  const vec4 tangents{1.0f, -0.5f, 0.0f, 0.0f};  // of half the field of view
  EXPECT_NEAR(pixel_footprint(4.0f, tangents, 1.0f, 100.0f), 0.04f, 1e-7);
  EXPECT_NEAR(pixel_footprint(4.0f, vec4(3.0f, -2.0f, 0.1f, 0.2f), 0.0f, 100.0f), 0.04f, 1e-7);
}

TEST(ContactShadow, RaysTakeOneStepAPixelAtMost) {
  EXPECT_EQ(contact_steps(0.0f, 12u), 1u);
  EXPECT_EQ(contact_steps(4.5f, 12u), 5u);
  EXPECT_EQ(contact_steps(12.0f, 12u), 12u);
  EXPECT_EQ(contact_steps(1e30f, 12u), 12u);
}

TEST(ContactShadow, SlopesDoNotReachAcrossEdges) {
  EXPECT_EQ(depth_slope(0.25f, 0.5f, 0.75f), 0.25f);
  EXPECT_EQ(depth_slope(0.25f, 0.5f, 0.125f), 0.25f);
  EXPECT_EQ(depth_slope(0.125f, 0.5f, 0.375f), -0.125f);
  // The far end of a floor before the sky: the step to nothing may be the smaller one.
  EXPECT_EQ(depth_slope(0.0f, 0.01f, 0.03f), 0.02f);
  EXPECT_EQ(depth_slope(0.03f, 0.01f, 0.0f), -0.02f);
  EXPECT_EQ(depth_slope(0.0f, 0.5f, 0.0f), 0.0f);
}

// Device depth of a plane, of either projection: the slope at a pixel is that to its neighbours.
TEST(ContactShadow, SlopesOfPlanesAreEverywhereTheSame) {
  const vec4 perspective = depth_params_perspective(0.1f, 100.0f), parallel = depth_params_orthographic(0.1f, 100.0f);
  // View depth where the plane z = 5 + 0.4 x meets the ray of x = ndc z (perspective) or x = ndc.
  const auto perspective_depth = [&](float ndc) { return device_depth(5.0f / (1.0f - 0.4f * ndc), perspective); };
  const auto parallel_depth = [&](float ndc) { return device_depth(5.0f + 0.4f * ndc, parallel); };
  for (float ndc = -0.9f; ndc < 0.9f; ndc += 0.1f) {
    const auto slope = [&](auto depth) { return depth_slope(depth(ndc - 0.01f), depth(ndc), depth(ndc + 0.01f)); };
    EXPECT_NEAR(slope(perspective_depth), perspective_depth(0.01f) - perspective_depth(0.0f), 1e-8);
    EXPECT_NEAR(slope(parallel_depth), parallel_depth(0.01f) - parallel_depth(0.0f), 2e-7);
  }
}

TEST(ContactShadow, BlockersAreBeforeTheRayAndThick) {
  EXPECT_FALSE(contact_blocked(1.99f, 2.0f, 0.1f));  // the ray passes before it
  EXPECT_FALSE(contact_blocked(2.0f, 2.0f, 0.1f));
  EXPECT_TRUE(contact_blocked(2.05f, 2.0f, 0.1f));
  EXPECT_FALSE(contact_blocked(2.11f, 2.0f, 0.1f));  // and behind it
}

TEST(ContactShadow, FadesAtItsEndAndAtThePicturesEdges) {
  EXPECT_EQ(contact_darkness(0.0f), 1.0f);
  EXPECT_EQ(contact_darkness(0.75f), 1.0f);
  EXPECT_NEAR(contact_darkness(0.875f), 0.5f, 1e-6);
  EXPECT_EQ(contact_darkness(1.0f), 0.0f);
  const vec2 size{100.0f, 50.0f};
  EXPECT_EQ(contact_border(vec2(50.0f, 25.0f), size), 1.0f);
  EXPECT_NEAR(contact_border(vec2(1.0f, 25.0f), size), 0.5f, 1e-6);
  EXPECT_NEAR(contact_border(vec2(50.0f, 49.5f), size), 0.25f, 1e-6);
  EXPECT_EQ(contact_border(vec2(0.0f, 25.0f), size), 0.0f);
}

TEST(ContactShadow, KeysNameTheStrongestLamp) {
  for (const uint index : {0u, 1u, 4095u, 16383u}) {
    EXPECT_EQ(light_of_key(dominant_light_key(0.37f, index)), index);
    EXPECT_EQ(light_of_key(dominant_light_key(1e38f, index)), index);
    EXPECT_EQ(dominant_light_key(0.0f, index), 0.0f);
  }
  // One part in 500 decides, whatever the lights' numbers.
  for (float luminance = 1e-20f; luminance < 1e20f; luminance *= 3.7f)
    EXPECT_GT(dominant_light_key(luminance * 1.002f, 0u), dominant_light_key(luminance, 16383u)) << luminance;
  EXPECT_LT(dominant_light_key(1e38f, 16383u), 2e30f);  // no infinity, nor what is no number
}

TEST(ContactShadow, OnlyALampThatGivesMoreThanHalfOfTheLightThrowsOne) {
  EXPECT_EQ(contact_weight(1.0f, 1.0f), 1.0f);
  EXPECT_EQ(contact_weight(0.75f, 1.0f), 1.0f);
  EXPECT_NEAR(contact_weight(0.625f, 1.0f), 0.5f, 1e-6);
  EXPECT_EQ(contact_weight(0.5f, 1.0f), 0.0f);
  EXPECT_EQ(contact_weight(0.4f, 1.0f), 0.0f);
  EXPECT_EQ(contact_weight(0.0f, 0.0f), 0.0f);
}

}  // namespace
}  // namespace velarium::shading
