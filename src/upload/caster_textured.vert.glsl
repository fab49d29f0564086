#version 460
#extension GL_GOOGLE_include_directive : require

#include "upload/caster.glsl"

layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_color;

layout(location = 0) out vec4 out_uv;
layout(location = 1) out vec4 out_color;

void main() {
  out_uv = in_uv;
  out_color = in_color;
  gl_Position = caster_position();
}
