// Surfaces as the G-buffer keeps them, read back to be lit. GLSL only.
#ifndef VEL_PASSES_GBUFFER_READ_GLSL
#define VEL_PASSES_GBUFFER_READ_GLSL

#include "passes/gbuffer/read_depth_buffer.glsl"
#include "passes/gbuffer/read_geometric_normal.glsl"
#include "passes/illumination.glsl"
#include "shading/gbuffer.glsl"

uint gbuffer_class(ivec2 pixel) {
  return texelFetch(gbuffer_stencil, pixel, 0).r & kStencilClass;
}

// depth: view depth, not 0. material_class: not kClassUnlit.
ShadingPoint gbuffer_point(ivec2 pixel, float depth, uint material_class) {
  GBufferTexel texel = GBufferTexel(texelFetch(gbuffer_normal, pixel, 0), texelFetch(gbuffer_albedo, pixel, 0),
                                    texelFetch(gbuffer_specular, pixel, 0));
  vec3 position_vs = position_at(pixel, depth);
  vec3 wo_vs = frame.perspective > 0.5 ? -normalize(position_vs) : vec3(0.0, 0.0, 1.0);
  mat3 world_from_view = transpose(view_rotation());
  Surface surface = gbuffer_decode(texel, material_class);
  vec3 position_ws = world_from_view * position_vs + frame.eye.xyz;
  ShadingPoint p = shading_point(surface, position_ws, world_from_view * wo_vs);
  if (kSunShadowMask) p.sun_visibility = 1.0 - texelFetch(sun_shadow_mask, pixel, 0).r;
  if (kLocalShadowTaps != 0u || kSunTranslucency)
    p.face_normal_ws = world_from_view * geometric_normal(pixel, position_vs, surface.normal_ws * world_from_view);
  return p;
}

#endif
