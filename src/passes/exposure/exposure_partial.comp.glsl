#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "passes/exposure/exposure_io.glsl"
#include "shading/display.glsl"

// One group makes one partial sum. It takes every gl_NumWorkGroups.x-th run of 128 pixels, a thread every 128th pixel,
// and adds in an order that depends on the size of the picture alone.

const uint kThreads = 128u;

layout(local_size_x = 128) in;
PUSH(PartialPush);

shared vec2 sums[kThreads];

void main() {
  uvec2 size = uvec2(textureSize(frame_sum, 0));
  uint count = size.x * size.y;
  vec2 mine = vec2(0.0f);
  for (uint i = gl_GlobalInvocationID.x; i < count; i += gl_NumWorkGroups.x * kThreads)
    mine += weighted_log2_luminance(texelFetch(frame_sum, ivec2(i % size.x, i / size.x), 0) * push.frame_weight);
  sums[gl_LocalInvocationIndex] = mine;
  for (uint half_size = kThreads / 2u; half_size > 0u; half_size /= 2u) {
    barrier();
    if (gl_LocalInvocationIndex < half_size)
      sums[gl_LocalInvocationIndex] += sums[gl_LocalInvocationIndex + half_size];
  }
  if (gl_LocalInvocationIndex == 0u) partials[gl_WorkGroupID.x] = sums[0];
}
