#version 460
#extension GL_GOOGLE_include_directive : require

#include "shading/brdf.glsl"
#include "shading/clip_volume.glsl"
#include "shading/contact_shadow.glsl"
#include "shading/display.glsl"
#include "shading/environment.glsl"
#include "shading/gbuffer.glsl"
#include "shading/light_volumes.glsl"
#include "shading/lights.glsl"
#include "shading/normal_encoding.glsl"
#include "shading/normal_variance.glsl"
#include "shading/projector.glsl"
#include "shading/sampling.glsl"
#include "shading/shadow_atlas.glsl"
#include "shading/shadow_bias.glsl"
#include "shading/shadow_filter.glsl"
#include "shading/sphere_light.glsl"
#include "shading/tile_culling.glsl"
#include "shading/tonemap.glsl"
#include "shading/translucency.glsl"
#include "shading/variance_shadow.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Inputs { vec4 inputs[]; };    // three a sample
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { vec4 outputs[]; };
layout(push_constant, std430) uniform Push { uint function; uint count; };

vec4 evaluate(vec4 a, vec4 b, vec4 c) {
  switch (function) {
#define PARITY(number, name, ulps, expression) \
  case number: return expression;
#include "functions.def"
  }
  return vec4(0.0);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  outputs[i] = evaluate(inputs[3u * i], inputs[3u * i + 1u], inputs[3u * i + 2u]);
}
