#version 460
#extension GL_GOOGLE_include_directive : require

#include "functions_io.glsl"
#include "shading/ambient_light.glsl"
#include "shading/brdf.glsl"
#include "shading/clip_volume.glsl"
#include "shading/contact_shadow.glsl"
#include "shading/display.glsl"
#include "shading/environment.glsl"
#include "shading/gbuffer.glsl"
#include "shading/light_volumes.glsl"
#include "shading/lights.glsl"
#include "shading/normal_encoding.glsl"
#include "shading/specular_aa.glsl"
#include "shading/projector.glsl"
#include "shading/sampling.glsl"
#include "shading/shadow_atlas.glsl"
#include "shading/shadow_bias.glsl"
#include "shading/shadow_filter.glsl"
#include "shading/area_lights.glsl"
#include "shading/tile_culling.glsl"
#include "shading/tonemap.glsl"
#include "shading/translucency.glsl"
#include "shading/variance_shadow.glsl"

layout(local_size_x = 64) in;

vec4 evaluate(vec4 a, vec4 b, vec4 c) {
  switch (push.function) {
// A row is known by its line.
#define PARITY(name, ulps, expression) \
  case __LINE__: return expression;
#include "functions.def"
  }
  return vec4(0.0);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= push.count) return;
  outputs[i] = evaluate(inputs[3u * i], inputs[3u * i + 1u], inputs[3u * i + 2u]);
}
