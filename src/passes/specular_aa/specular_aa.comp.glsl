#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

// The variance of normals between a pixel and its neighbours on the same surface widens its lobe [Schulz 2014, Ryse;
// after Mittring & Dudash 2012].

#include "passes/gbuffer/gbuffer_io.glsl"
#include "passes/specular_aa/specular_aa_io.glsl"
#include "shading/depth.glsl"
#include "shading/normal_encoding.glsl"
#include "shading/specular_aa.glsl"
#include "upload/frame.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

const float kNowhere = 1e30;

// Of where a surface is expected: behind the farthest depth is nothing.
float view_depth_or_nowhere(float device_depth) {
  return device_depth > 0.0 ? view_depth(device_depth, frame.depth_params) : kNowhere;
}

// The pixel that the filter widens.
struct Center {
  float device_depth, z;
  vec3 normal_ws;
};

// xyz: the normal there by its weight w. expected: the device depth there of a plane through the center and the
// neighbour across it. On the surface is what is as deep as the center, or lies in that plane; what faces another way
// is another surface, beyond an edge.
vec4 weighted_normal(ivec2 pixel, float device_depth, float expected, Center center) {
  vec3 stored = texelFetch(gbuffer_normal, pixel, 0).rgb;
  if (device_depth <= 0.0 || stored == vec3(0.0)) return vec4(0.0);   // nothing, or unlit
  float z = view_depth(device_depth, frame.depth_params);
  float off_m = min(abs(z - center.z), abs(z - view_depth_or_nowhere(expected)));
  vec3 normal_ws = bfn_decode(stored);
  float facing = clamp(dot(normal_ws, center.normal_ws), 0.0, 1.0);
  return vec4(normal_ws, 1.0) * screen_tap_weight(off_m, center.z) * facing;
}

// Both neighbours along one axis. Device depth is linear on the screen over a plane.
vec4 weighted_normals(ivec2 pixel, ivec2 axis, Center center) {
  ivec2 last = ivec2(frame.size.xy) - 1;
  ivec2 before = max(pixel - axis, ivec2(0)), after = min(pixel + axis, last);
  float depth_before = texelFetch(gbuffer_depth, before, 0).r, depth_after = texelFetch(gbuffer_depth, after, 0).r;
  return weighted_normal(before, depth_before, 2.0 * center.device_depth - depth_after, center) +
         weighted_normal(after, depth_after, 2.0 * center.device_depth - depth_before, center);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, ivec2(frame.size.xy)))) return;
  vec4 stored = imageLoad(specular, pixel);
  if (stored.r <= kScreenFilterLeastSmoothness) return;   // where nothing is lit it is 0
  Center center;
  center.device_depth = texelFetch(gbuffer_depth, pixel, 0).r;
  center.z = view_depth(center.device_depth, frame.depth_params);
  center.normal_ws = bfn_decode(texelFetch(gbuffer_normal, pixel, 0).rgb);
  vec4 sum = vec4(center.normal_ws, 1.0);
  sum += weighted_normals(pixel, ivec2(1, 0), center);
  sum += weighted_normals(pixel, ivec2(0, 1), center);

  float spread2 = min(push.share * spread2_from_screen_mean(length(sum.xyz) / sum.w), kScreenMostSpread2);
  float widened = widened_smoothness(stored.r, spread2);
  if (push.dim_dielectrics != 0u) stored.g = dimmed_specular_y(stored.g, stored.r, widened);
  stored.r = widened;
  imageStore(specular, pixel, stored);
}
