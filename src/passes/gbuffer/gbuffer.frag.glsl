#version 460
#extension GL_GOOGLE_include_directive : require

#include "shading/constants.glsl"
#include "shading/gbuffer.glsl"
#include "upload/material.glsl"

layout(constant_id = 1) const uint kAlphaTest = 0u;   // 1: MASK

layout(set = 1, binding = 0) uniform sampler2D normal_lengths;

layout(location = 0) in vec3 in_normal_ws;
layout(location = 1) in vec4 in_tangent_ws;
layout(location = 2) in vec4 in_uv;
layout(location = 3) in vec4 in_color;

layout(location = 0) out vec4 out_rt0;
layout(location = 1) out vec4 out_rt1;
layout(location = 2) out vec4 out_rt2;
layout(location = 3) out vec4 out_emissive;   // rgb: nits; a: coverage

void main() {
  FragmentInput f = FragmentInput(in_normal_ws, in_tangent_ws, in_uv, in_color, gl_FrontFacing);
  vec4 base_color = material_base_color(f);
  if (kAlphaTest != 0u && base_color.a < material.metal_rough.w) discard;

  // Points and lines without normals are unlit, too (glTF 2.0, 3.7.2.1).
  bool unlit = (material.flags & kMaterialUnlit) != 0u || dot(f.normal_ws, f.normal_ws) == 0.0;
  if (unlit) {
    out_rt0 = out_rt1 = out_rt2 = vec4(0.0);
    out_emissive = vec4(min(base_color.rgb, kLargestHalf), 1.0);
    return;
  }
  Surface surface = material_surface(f, base_color.rgb);
  float table = textureLod(normal_lengths, bfn_table_uv(surface.normal_ws), 0.0).r;
  GBufferTexel texel = gbuffer_shifted(gbuffer_encode(surface, table), frame.rounding);
  out_rt0 = texel.rt0;
  out_rt1 = texel.rt1;
  out_rt2 = texel.rt2;
  out_emissive = vec4(min(material_emissive(f), kLargestHalf), 1.0);
}
