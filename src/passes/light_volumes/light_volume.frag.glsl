#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

// One light on the surface of one pixel.

#include "passes/gbuffer/read.glsl"
#include "passes/light_volumes/light_volumes_io.glsl"
#include "shading/contact_shadow.glsl"

layout(location = 0) flat in uint in_light;

layout(location = 0) out vec4 out_light;   // added up; a: dominant_light_key(), of which the largest stays

vec3 light_of_kind(ShadingPoint p) {
  if (kKind == 0u) return light_directional(p, in_light);
  return kKind == 1u ? light_point(p, in_light) : light_spot(p, in_light);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint material_class = gbuffer_class(pixel);
  out_light = vec4(0.0);
  if (material_class == kClassUnlit) return;
  vec3 radiance = light_of_kind(gbuffer_point(pixel, linear_depth_at(pixel), material_class));
  out_light = vec4(radiance, dominant_light_key(luminance(radiance), in_light));
}
