#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "passes/exposure/exposure_io.glsl"
#include "shading/display.glsl"

layout(local_size_x = 1) in;
PUSH(ResolvePush);

void main() {
  vec2 sum = vec2(0.0f);
  for (int i = 0; i < partials.length(); ++i) sum += partials[i];
  exposure = push.scale * automatic_exposure(sum);
}
