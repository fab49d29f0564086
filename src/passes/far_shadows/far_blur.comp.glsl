#version 460
#extension GL_GOOGLE_include_directive : require

// One direction of a separable blur of the first two moments of depth: along rows, from a map of depth; then along
// columns, from what that wrote.

#include "shading/variance_shadow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const uint kColumns = 0u;  // 0: rows, of depth

layout(set = 0, binding = 0) uniform sampler2DArray source;
layout(set = 0, binding = 1, r32f) writeonly uniform image2DArray moments;  // layer 0: mean, layer 1: mean square

const int kMostTexels = 11;
layout(push_constant, std430) uniform Push {
  int radius;                  // texels, less than kMostTexels
  float weights[kMostTexels];  // by distance from the middle; their sum over all texels is 1
};

// Where nothing was drawn, a depth behind the map's end: a surface that slopes away from the sun up to its rim there would
// go on at least as far, within a blur of an eighth of the map.
const float kNothing = -0.125;

vec2 moments_at(ivec2 texel) {
  float first = texelFetch(source, ivec3(texel, 0), 0).r;
  if (kColumns != 0u) return vec2(first, texelFetch(source, ivec3(texel, 1), 0).r);
  return depth_moments(moment_depth(first > 0.0 ? first : kNothing));
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy), last = textureSize(source, 0).xy - 1;
  if (any(greaterThan(texel, last))) return;
  ivec2 along = kColumns == 0u ? ivec2(1, 0) : ivec2(0, 1);
  vec2 sum = vec2(0.0);
  for (int i = -radius; i <= radius; ++i)
    sum += weights[abs(i)] * moments_at(clamp(texel + i * along, ivec2(0), last));
  imageStore(moments, ivec3(texel, 0), vec4(sum.x));
  imageStore(moments, ivec3(texel, 1), vec4(sum.y));
}
