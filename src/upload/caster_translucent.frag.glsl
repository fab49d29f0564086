#version 460
#extension GL_GOOGLE_include_directive : require

#include "shading/translucency.glsl"
#include "upload/material.glsl"

layout(location = 0) in vec4 in_uv;
layout(location = 1) in vec4 in_color;

// rgb: multiplied into what passes the surfaces before; a: depth, of which the largest, the nearest to the light, stays.
// The bias is taken here, as drivers differ in whether gl_FragCoord has that of the rasteriser.
layout(location = 0) out vec4 out_translucency;

void main() {
  FragmentInput f = FragmentInput(vec3(0.0), vec4(0.0), in_uv, in_color, true);
  vec4 color = clamp(material_base_color(f), 0.0, 1.0);
  vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
  out_translucency = vec4(blend_transmittance(color.rgb, color.a), translucency_depth(gl_FragCoord.z, slope));
}
