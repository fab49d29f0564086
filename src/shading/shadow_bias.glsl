// What keeps a surface from shadowing itself: a map knows depth at texels alone, and a tilted surface differs from
// that by up to the tangent of its tilt within one.
#ifndef VEL_SHADING_SHADOW_BIAS_GLSL
#define VEL_SHADING_SHADOW_BIAS_GLSL

#include "shading/lang.glsl"

// How far to move a receiver along its geometric normal, in the unit of `texel`, so that depths `texels` of the map
// beside it do not hide it: (k + 1/2) w sin(a). Unlike a depth bias, which grows with the tangent, it is bounded.
// cos_tilt: of the normal and the way to the light.
FN float shadow_normal_offset(float cos_tilt, float texels, float texel) {
  float c = clamp(cos_tilt, -1.0f, 1.0f);
  return texels * texel * sqrt(1.0f - c * c);
}

// The same as a difference in depth, (k + 1/2) w tan(a), for maps that cannot move their receiver. Bounded as the
// tangent is, at a tilt of 84 degrees: beyond that light is faint.
const float kMaxTiltTangent = 10.0f;

FN float shadow_depth_bias(float cos_tilt, float texels, float texel) {
  float c = clamp(cos_tilt, 0.0f, 1.0f);
  float tangent = min(sqrt(1.0f - c * c) / max(c, 1e-4f), kMaxTiltTangent);
  return texels * texel * tangent;
}

#endif
