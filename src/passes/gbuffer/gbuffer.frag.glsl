#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "passes/gbuffer/gbuffer_out_io.glsl"
#include "shading/constants.glsl"
#include "shading/gbuffer.glsl"
#include "upload/frame.glsl"
#include "upload/material.glsl"

#define VARYING in
#include "upload/varyings.glsl"

layout(location = 0) out vec4 out_normal;
layout(location = 1) out vec4 out_albedo;
layout(location = 2) out vec4 out_specular;
layout(location = 3) out vec4 out_emissive;   // rgb: nits; a: coverage

void main() {
  FragmentInput f = FragmentInput(varying_normal_ws, varying_tangent_ws, varying_uv, varying_color, gl_FrontFacing);
  vec4 base_color = material_base_color(f);
  if (kAlphaTest && base_color.a < material.metal_rough.w) discard;

  if (is_unlit(f)) {
    out_normal = out_albedo = out_specular = vec4(0.0);
    out_emissive = vec4(min(unlit_radiance(f, base_color.rgb), kLargestHalf), 1.0);
    return;
  }
  Surface surface = material_surface(f, base_color.rgb);
  float table_size = float(textureSize(normal_lengths, 0).x);
  float table = texelFetch(normal_lengths, ivec2(bfn_table_texel(surface.normal_ws, table_size)), 0).r;
  GBufferTexel texel = gbuffer_shifted(gbuffer_encode(surface, table), frame.rounding);
  out_normal = texel.normal;
  out_albedo = texel.albedo;
  out_specular = texel.specular;
  out_emissive = vec4(min(material_emissive(f), kLargestHalf), 1.0);
}
