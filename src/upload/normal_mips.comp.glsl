#version 460
#extension GL_GOOGLE_include_directive : require

// One level of a normal map: src/upload/normal_mips.hpp. Means go from level to level as 32-bit floats.

#include "shading/normal_variance.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba8) readonly uniform image2D base;  // level 0
layout(set = 0, binding = 1, rgba8) writeonly uniform image2D level;
layout(set = 0, binding = 2, std430) buffer MeansBuffer { vec4 means[]; };  // of all levels but the first

layout(push_constant, std430) uniform Push {
  uvec2 from_size;
  uvec2 to_size;
  uint from_first;  // means of the level above, from here on
  uint to_first;
  uint from_base;  // 1: the level above is level 0, which has no means yet
};

vec3 mean_at(uvec2 place) {
  if (from_base == 0u) return means[from_first + place.y * from_size.x + place.x].xyz;
  return normalize(2.0 * imageLoad(base, ivec2(place)).rgb - 1.0);
}

void main() {
  uvec2 texel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(texel, to_size))) return;
  // As vkCmdBlitImage with a linear filter: the two by two texels around the centre.
  vec2 center = (vec2(texel) + 0.5) * vec2(from_size) / vec2(to_size) - 0.5;
  uvec2 first = uvec2(center);
  uvec2 second = min(first + 1u, from_size - 1u);
  vec2 share = center - vec2(first);
  vec3 upper = mix(mean_at(first), mean_at(uvec2(second.x, first.y)), share.x);
  vec3 lower = mix(mean_at(uvec2(first.x, second.y)), mean_at(second), share.x);
  vec3 mean = mix(upper, lower, share.y);

  means[to_first + texel.y * to_size.x + texel.x] = vec4(mean, 0.0);
  float r = length(mean);
  imageStore(level, ivec2(texel), vec4(0.5 * mean / max(r, 1e-6) + 0.5, spread_from_mean_length(r)));
}
