// Device depth, reversed: 1 at the near plane, 0 at the far plane or at infinity. View depth: metres along the view
// axis. depth_params p of a projection: view depth = (p.x + p.y d) / (p.z + p.w d).
#ifndef VEL_SHADING_DEPTH_GLSL
#define VEL_SHADING_DEPTH_GLSL

#include "shading/lang.glsl"

// Perspective, far plane at infinity: d = z_near / z.
FN vec4 depth_params_infinite(float z_near) {
  return vec4(z_near, 0.0f, 0.0f, 1.0f);
}

// Perspective, 0 < z_near < z_far: d = z_near (z_far - z) / (z (z_far - z_near)).
FN vec4 depth_params_perspective(float z_near, float z_far) {
  return vec4(z_near * z_far, 0.0f, z_near, z_far - z_near);
}

// Orthographic: d = (z_far - z) / (z_far - z_near).
FN vec4 depth_params_orthographic(float z_near, float z_far) {
  return vec4(z_far, z_near - z_far, 1.0f, 0.0f);
}

// Metres. Where nothing was drawn (d = 0) an infinite projection gives a depth beyond every scene, yet finite.
FN float view_depth(float device_depth, vec4 depth_params) {
  vec4 p = depth_params;
  return (p.x + p.y * device_depth) / max(p.z + p.w * device_depth, 1e-30f);
}

// The inverse of view_depth, for depths in front of the eye.
FN float device_depth(float view_depth, vec4 depth_params) {
  vec4 p = depth_params;
  return (p.x - p.z * view_depth) / (p.w * view_depth - p.y);
}

// Lateral view-space position of a point of the screen at this depth. ndc: x right, y down, -1..1 (Vulkan).
// ndc_to_view: scale (xy) and offset (zw), at depth 1 for a perspective view. perspective: 1, or 0 for orthographic.
FN vec2 view_position_xy(vec2 ndc, float depth, vec4 ndc_to_view, float perspective) {
  vec2 at_one = ndc * vec2(ndc_to_view.x, ndc_to_view.y) + vec2(ndc_to_view.z, ndc_to_view.w);
  return at_one * mix(1.0f, depth, perspective);
}

// View space, metres: x right, y up, the view looks along -z.
FN vec3 view_position(vec2 ndc, float depth, vec4 ndc_to_view, float perspective) {
  return vec3(view_position_xy(ndc, depth, ndc_to_view, perspective), -depth);
}

#endif
