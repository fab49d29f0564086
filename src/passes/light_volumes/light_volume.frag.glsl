#version 460
#extension GL_GOOGLE_include_directive : require

// One light on the surface of one pixel.

#include "upload/gpu_structs.glsl"

layout(set = 0, binding = 0, std430) readonly buffer FrameBuffer { FrameUniforms frame; };

#include "shading/contact_shadow.glsl"
#include "upload/gbuffer_point.glsl"

layout(constant_id = 20) const uint kKind = 0u;   // light_volumes::VolumeDraw::kind

layout(location = 0) flat in uint in_light;

layout(location = 0) out vec4 out_light;   // added up; a: strength_key(), of which the largest stays

vec3 light_of_kind(ShadingPoint p) {
  if (kKind == 0u) return light_directional(p, in_light);
  return kKind == 1u ? light_point(p, in_light) : light_spot(p, in_light);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint material_class = gbuffer_class(pixel);
  out_light = vec4(0.0);
  if (material_class == kClassUnlit) return;
  vec3 radiance = light_of_kind(gbuffer_point(pixel, depth_at(pixel), material_class));
  out_light = vec4(radiance, strength_key(luminance(radiance), in_light));
}
