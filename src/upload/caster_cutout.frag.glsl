#version 460
#extension GL_GOOGLE_include_directive : require

#include "upload/material.glsl"

layout(location = 0) in vec4 in_uv;
layout(location = 1) in vec4 in_color;

void main() {
  FragmentInput f = FragmentInput(vec3(0.0), vec4(0.0), in_uv, in_color, true);
  if (material_base_color(f).a < material.metal_rough.w) discard;
}
