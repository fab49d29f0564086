#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

// Transparent surfaces, shaded where they are drawn, by the same maths and the same light lists as the opaque ones.

#include "passes/forward/forward_io.glsl"
#include "passes/lighting/read.glsl"
#include "shading/constants.glsl"
#include "upload/material.glsl"

#define VARYING in
#include "upload/varyings.glsl"

layout(location = 0) out vec4 out_hdr;   // premultiplied

uint tile_light_word(uint word) {
  uint words = (light_ranges.count + 31u) / 32u;
  uint tiles_x = (uint(frame.size.x) + kTileSize - 1u) / kTileSize;
  uvec2 tile = uvec2(gl_FragCoord.xy) / kTileSize;
  return forward_lists[(tile.y * tiles_x + tile.x) * words + word];
}

vec3 shade(FragmentInput f, vec3 base_color) {
  vec3 wo_ortho = transpose(view_rotation()) * vec3(0.0, 0.0, 1.0);
  vec3 wo = frame.perspective > 0.5 ? -normalize(varying_position_ws - frame.eye.xyz) : wo_ortho;
  ShadingPoint p = shading_point(material_surface(f, base_color), varying_position_ws, wo);
  p.face_normal_ws = normalize(cross(dFdx(varying_position_ws), dFdy(varying_position_ws)));
  vec3 light = material_emissive(f) + environment_light(p);
  // What is transparent is not in the depth that contact shadows are found in.
  if (kLights) light += punctual_lights(p).sum;
  return light;
}

void main() {
  FragmentInput f = FragmentInput(varying_normal_ws, varying_tangent_ws, varying_uv, varying_color, gl_FrontFacing);
  vec4 base_color = material_base_color(f);
  float alpha = clamp(base_color.a, 0.0, 1.0);
  receiver_transmittance = blend_transmittance(clamp(base_color.rgb, 0.0, 1.0), alpha);
  vec3 radiance = is_unlit(f) ? unlit_radiance(f, base_color.rgb) : shade(f, base_color.rgb);
  out_hdr = vec4(min(radiance, kLargestHalf) * alpha, alpha);
}
