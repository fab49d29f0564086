#version 460
#extension GL_GOOGLE_include_directive : require

// One level of a normal map: src/upload/normal_mips.hpp. Means go from level to level as 32-bit floats.

#include "shading/specular_aa.glsl"
#include "upload/normal_mips_io.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

vec3 mean_at(uvec2 place) {
  if (push.from_base == 0u) return means[push.from_first + place.y * push.from_size.x + place.x].xyz;
  return normalize(2.0 * imageLoad(base, ivec2(place)).rgb - 1.0);
}

vec3 filtered_mean(uvec2 texel) {
  // As vkCmdBlitImage with a linear filter: the two by two texels around the centre.
  vec2 center = (vec2(texel) + 0.5) * vec2(push.from_size) / vec2(push.to_size) - 0.5;
  uvec2 first = uvec2(center);
  uvec2 second = min(first + 1u, push.from_size - 1u);
  vec2 share = center - vec2(first);
  vec3 upper = mix(mean_at(first), mean_at(uvec2(second.x, first.y)), share.x);
  vec3 lower = mix(mean_at(uvec2(first.x, second.y)), mean_at(second), share.x);
  vec3 mean = mix(upper, lower, share.y);
  if (push.from_base == 0u) return mean;
  float r = length(mean);
  return mean * (interpolated_mean_length(r) / max(r, 1e-6));
}

// Two by two texels, or what of them lies inside.
void main() {
  uvec2 block = 2u * gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(block, push.to_size))) return;
  vec3 block_means[4];
  vec3 directions = vec3(0.0);
  for (uint i = 0u; i < 4u; ++i) {
    uvec2 texel = min(block + uvec2(i % 2u, i / 2u), push.to_size - 1u);
    vec3 mean = filtered_mean(texel);
    block_means[i] = mean;
    directions += mean / max(length(mean), 1e-6);
    means[push.to_first + texel.y * push.to_size.x + texel.x] = vec4(mean, 0.0);
  }
  float gap = interpolation_gap(0.25 * length(directions));
  for (uint i = 0u; i < 4u; ++i) {
    uvec2 texel = min(block + uvec2(i % 2u, i / 2u), push.to_size - 1u);
    float r = length(block_means[i]);
    vec3 direction = block_means[i] / max(r, 1e-6);
    imageStore(level, ivec2(texel), vec4(0.5 * direction + 0.5, spread_from_mean_length(gap * r)));
  }
}
