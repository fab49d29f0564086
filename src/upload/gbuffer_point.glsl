// Surfaces as the G-buffer keeps them, read back to be lit. GLSL only.
// The includer defines, before: FrameUniforms frame; the images below are bound in set 0.
#ifndef VEL_UPLOAD_GBUFFER_POINT_GLSL
#define VEL_UPLOAD_GBUFFER_POINT_GLSL

#include "shading/gbuffer.glsl"
#include "upload/frame_lighting.glsl"

layout(set = 0, binding = 1) uniform sampler2D rt0;
layout(set = 0, binding = 2) uniform sampler2D rt1;
layout(set = 0, binding = 3) uniform sampler2D rt2;
layout(set = 0, binding = 4) uniform sampler2D depth_map;
layout(set = 0, binding = 5) uniform usampler2D class_map;
layout(set = 1, binding = 8) uniform sampler2D sun_mask;   // occlusion

#include "upload/geometric_normal.glsl"
#include "upload/picture_depth.glsl"

uint gbuffer_class(ivec2 pixel) {
  return texelFetch(class_map, pixel, 0).r & 3u;
}

// Of the pixel whose point is being lit: the mask is the one thing that knows pixels.
float pixel_sun_visibility = 1.0;

float sun_visibility(ShadingPoint p) {
  return pixel_sun_visibility;
}

// depth: view depth, not 0. material_class: not kClassUnlit.
ShadingPoint gbuffer_point(ivec2 pixel, float depth, uint material_class) {
  if (kSunShadows != 0u) pixel_sun_visibility = 1.0 - texelFetch(sun_mask, pixel, 0).r;
  GBufferTexel texel = GBufferTexel(texelFetch(rt0, pixel, 0), texelFetch(rt1, pixel, 0), texelFetch(rt2, pixel, 0));
  vec3 position_vs = position_at(pixel, depth);
  vec3 wo_vs = frame.perspective > 0.5 ? -normalize(position_vs) : vec3(0.0, 0.0, 1.0);
  mat3 world_from_view = transpose(mat3(frame.view_from_world));
  Surface surface = gbuffer_decode(texel, material_class);
  vec3 position_ws = world_from_view * position_vs;
  ShadingPoint p = shading_point(surface, position_ws, world_from_view * wo_vs);
  if (kLocalShadows != 0u || (kTranslucentShadows & kSunVeils) != 0u)
    p.face_normal_ws = world_from_view * geometric_normal(pixel, position_vs, surface.normal_ws * world_from_view);
  return p;
}

#endif
