#version 460
#extension GL_GOOGLE_include_directive : require

#include "shading/display.glsl"

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std430) readonly buffer Partials { vec2 partials[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Exposure { float exposure; };
layout(push_constant) uniform Push { float scale; };

void main() {
  vec2 sum = vec2(0.0f);
  for (int i = 0; i < partials.length(); ++i) sum += partials[i];
  exposure = scale * automatic_exposure(sum);
}
