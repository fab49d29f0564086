#include <gtest/gtest.h>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

// At the origin, looking along -Z with +X to the right: half of the field is 45 degrees.
GpuLight projector() {
  GpuLight l{};
  l.direction = vec4(0.0f, 0.0f, -1.0f, kLightSpot);
  l.projector = vec4(1.0f, 0.0f, 0.0f, 1.0f);
  return l;
}

vec2 uv_at(const GpuLight& l, const vec3& point) {
  return projector_uv(l, normalize(-point));
}

TEST(Projector, SeesItsPictureUprightAsItsNodeDoes) {
  const GpuLight l = projector();
  EXPECT_LT(length(uv_at(l, vec3(0.0f, 0.0f, -3.0f)) - vec2(0.5f, 0.5f)), 1e-6f);
  EXPECT_LT(length(uv_at(l, vec3(0.5f, 0.25f, -1.0f)) - vec2(0.75f, 0.375f)), 1e-6f);  // right of the middle, above it
  EXPECT_LT(length(uv_at(l, vec3(-2.0f, -2.0f, -2.0f)) - vec2(0.0f, 1.0f)), 1e-6f);
  EXPECT_TRUE(in_projector(uv_at(l, vec3(-1.9f, 1.9f, -2.0f))));
  EXPECT_FALSE(in_projector(uv_at(l, vec3(2.1f, 0.0f, -2.0f))));
  EXPECT_FALSE(in_projector(uv_at(l, vec3(0.0f, 0.0f, 2.0f))));
}

TEST(Projector, FieldOfViewSpansThePicture) {
  GpuLight l = projector();
  l.projector.w = std::tan(0.3f);
  EXPECT_NEAR(uv_at(l, vec3(std::tan(0.3f), 0.0f, -1.0f)).x, 1.0f, 1e-6);
  EXPECT_NEAR(uv_at(l, vec3(std::tan(-0.3f), 0.0f, -1.0f)).x, 0.0f, 1e-6);
}

// Turned by a rotation, the light sees the turned points as before.
TEST(Projector, TurnsWithTheLight) {
  Random random(41);
  for (int i = 0; i < 1000; ++i) {
    const vec3 back = random.direction();
    vec3 right, up;
    tangent_frame(back, right, up);
    GpuLight l = projector();
    l.direction = vec4(-back, kLightSpot);
    l.projector = vec4(right, 1.0f);
    const vec3 point(random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f), -1.5f);
    const vec3 turned = point.x * right + point.y * up + point.z * back;
    ASSERT_LT(length(uv_at(l, turned) - uv_at(projector(), point)), 1e-5f);
  }
}

}  // namespace
}  // namespace velarium::shading
