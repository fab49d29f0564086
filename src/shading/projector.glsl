// The picture that a spot light throws.
#ifndef VEL_SHADING_PROJECTOR_GLSL
#define VEL_SHADING_PROJECTOR_GLSL

#include "shading/lang.glsl"
#include "shading/lights.glsl"

// Where in the picture's square the light passes on its way to a point: from (0, 0) at the upper left, seen along the
// light, to (1, 1). Outside of that where nothing passes. wi: unit, from the point towards the light.
FN vec2 projector_uv(IN(GpuLight) l, vec3 wi) {
  vec3 axis = vec3(l.direction.x, l.direction.y, l.direction.z);
  vec3 right = vec3(l.projector.x, l.projector.y, l.projector.z);
  float ahead = -dot(axis, wi) * l.projector.w;
  if (ahead <= 0.0f) return vec2(-1.0f);
  vec2 place = vec2(-dot(right, wi), -dot(cross(right, axis), wi)) / ahead;
  return vec2(0.5f) + 0.5f * vec2(place.x, -place.y);
}

FN bool in_projector(vec2 uv) {
  return min(uv.x, uv.y) >= 0.0f && max(uv.x, uv.y) <= 1.0f;
}

#endif
