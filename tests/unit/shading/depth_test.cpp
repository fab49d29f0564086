#include <gtest/gtest.h>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

TEST(Depth, KnownValues) {
  const vec4 p = depth_params_perspective(0.1f, 1000.0f);
  EXPECT_NEAR(1.0f - device_depth(1.0f, p), 0.9000900f, 1e-6);
  EXPECT_NEAR(1.0f - device_depth(10.0f, p), 0.9900990f, 1e-6);
  EXPECT_NEAR(device_depth(0.1f, p), 1.0f, 1e-6);
  EXPECT_NEAR(device_depth(1000.0f, p), 0.0f, 1e-9);
  EXPECT_NEAR(device_depth(10.0f, depth_params_infinite(0.1f)), 0.01f, 1e-8);
  const vec4 ortho = depth_params_orthographic(2.0f, 12.0f);
  EXPECT_EQ(device_depth(2.0f, ortho), 1.0f);
  EXPECT_EQ(device_depth(12.0f, ortho), 0.0f);
  EXPECT_NEAR(device_depth(4.5f, ortho), 0.75f, 1e-7);
}

TEST(Depth, RoundTrips) {
  for (const vec4& p : {depth_params_perspective(0.1f, 1000.0f), depth_params_infinite(0.1f)}) {
    for (const float z : {0.1f, 1.0f, 10.0f, 100.0f, 500.0f, 999.0f}) {
      EXPECT_NEAR(view_depth(device_depth(z, p), p) / z, 1.0f, 1e-5) << z;
    }
  }
  const vec4 ortho = depth_params_orthographic(2.0f, 12.0f);
  for (const float z : {2.0f, 3.3f, 12.0f}) EXPECT_NEAR(view_depth(device_depth(z, ortho), ortho), z, 1e-5);
}

// One step of fp32 at 500 m, against 0.149 m of conventional 24-bit integers.
TEST(Depth, ReversedFloatsAreFineFarAway) {
  const vec4 p = depth_params_infinite(0.1f);
  const float d = device_depth(500.0f, p);
  EXPECT_LT(view_depth(std::nextafter(d, 0.0f), p) - view_depth(d, p), 6.2e-5f);
}

TEST(Depth, EmptyPixelsAreFarButFinite) {
  EXPECT_EQ(view_depth(0.0f, depth_params_perspective(0.1f, 1000.0f)), 1000.0f);
  const float sky = view_depth(0.0f, depth_params_infinite(0.1f));
  EXPECT_TRUE(std::isfinite(sky));
  EXPECT_GT(sky, 1e20f);
}

TEST(Depth, PositionProjectsBackToItsPixel) {
  const float tan_y = std::tan(0.5f * 1.0471976f), tan_x = tan_y * 1920.0f / 1080.0f;
  const vec4 ndc_to_view{tan_x, -tan_y, 0.01f, 0.02f};  // off axis a little, as jitter and tiles are
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const vec2 ndc{random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f)};
    const float z = random.uniform(0.2f, 900.0f);
    const vec3 p = view_position(ndc, z, ndc_to_view, 1.0f);
    EXPECT_EQ(p.z, -z);
    EXPECT_NEAR((p.x / z - ndc_to_view.z) / ndc_to_view.x * 960.0f, ndc.x * 960.0f, 1e-2);
    EXPECT_NEAR((p.y / z - ndc_to_view.w) / ndc_to_view.y * 540.0f, ndc.y * 540.0f, 1e-2);
  }
  EXPECT_EQ(view_position(vec2(0.5f, 1.0f), 7.0f, vec4(4.0f, -3.0f, 0.0f, 0.0f), 0.0f), vec3(2.0f, -3.0f, -7.0f));
}

}  // namespace
}  // namespace velarium::shading
