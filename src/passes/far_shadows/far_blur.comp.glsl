#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

// One direction of a separable blur of the first two moments of depth: along rows, from a map of depth; then along
// columns, from what that wrote.

#include "passes/far_shadows/far_blur_io.glsl"
#include "shading/variance_shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// Where nothing was drawn, a depth behind the map's end: a surface that slopes away from the sun up to its rim there would
// go on at least as far, within a blur of an eighth of the map.
const float kNothing = -0.125;

vec2 moments_at(ivec2 texel) {
  float first = texelFetch(blur_source, ivec3(texel, 0), 0).r;
  if (kColumns) return vec2(first, texelFetch(blur_source, ivec3(texel, 1), 0).r);
  return depth_moments(moment_depth(first > 0.0 ? first : kNothing));
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy), last = textureSize(blur_source, 0).xy - 1;
  if (any(greaterThan(texel, last))) return;
  ivec2 along = !kColumns ? ivec2(1, 0) : ivec2(0, 1);
  vec2 sum = vec2(0.0);
  for (int i = -push.radius; i <= push.radius; ++i)
    sum += push.weights[abs(i)] * moments_at(clamp(texel + i * along, ivec2(0), last));
  imageStore(blur_moments, ivec3(texel, 0), vec4(sum.x));
  imageStore(blur_moments, ivec3(texel, 1), vec4(sum.y));
}
