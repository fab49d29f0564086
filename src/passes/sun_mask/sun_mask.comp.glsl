#version 460
#extension GL_GOOGLE_include_directive : require

// How much of the sun is hidden from each pixel [Crytek, "Secrets of CryENGINE 3 Graphics Technology", 2011: deferred
// shadow mask]. What the sun cannot light anyway is left at 0: the sky, and surfaces that face away.

#include "shading/depth.glsl"
#include "shading/normal_encoding.glsl"
#include "shading/sampling.glsl"
#include "upload/gpu_structs.glsl"
#include "upload/sun_shadows.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, std430) readonly buffer FrameBuffer { FrameUniforms frame; };
layout(set = 0, binding = 1) uniform sampler2D rt0;
layout(set = 0, binding = 4) uniform sampler2D depth_map;
layout(set = 0, binding = 6, r32f) writeonly uniform image2D occlusion;

#include "upload/contact_shadows.glsl"

// View depth, or 0 where nothing was drawn and outside the picture.
float depth_at(ivec2 pixel) {
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(vec2(pixel), frame.size.xy))) return 0.0;
  float device_depth = texelFetch(depth_map, pixel, 0).r;
  return device_depth > 0.0 ? view_depth(device_depth, frame.depth_params) : 0.0;
}

vec3 position_at(ivec2 pixel, float depth) {
  vec2 ndc = (vec2(pixel) + 0.5) * frame.size.zw * 2.0 - 1.0;
  return view_position(ndc, depth, frame.ndc_to_view, frame.perspective);
}

// The way along the surface to a neighbour at this offset or the opposite one: to that which is nearer in depth, as the
// other may belong to another surface. Null where neither was drawn.
vec3 surface_step(ivec2 pixel, float depth, vec3 position, ivec2 offset) {
  float after = depth_at(pixel + offset), before = depth_at(pixel - offset);
  if (after == 0.0 && before == 0.0) return vec3(0.0);
  bool forwards = before == 0.0 || (after != 0.0 && abs(after - depth) < abs(before - depth));
  if (forwards) return position_at(pixel + offset, after) - position;
  return position - position_at(pixel - offset, before);
}

// The normal of the surface itself, view space: what normal maps and interpolation say differs from how the maps see
// it.
vec3 geometric_normal(ivec2 pixel, float depth, vec3 position, vec3 shading_normal) {
  vec3 n = cross(surface_step(pixel, depth, position, ivec2(0, 1)), surface_step(pixel, depth, position, ivec2(1, 0)));
  float squared = dot(n, n);
  return squared > 0.0 ? n * inversesqrt(squared) : shading_normal;
}

float pixel_occlusion(ivec2 pixel) {
  float depth = depth_at(pixel);
  if (depth == 0.0) return 0.0;
  vec3 normal_ws = bfn_decode(texelFetch(rt0, pixel, 0).rgb);
  if (dot(normal_ws, sun.axis_z.xyz) <= 0.0) return 0.0;
  vec3 position_vs = position_at(pixel, depth);
  mat3 world_from_view = transpose(mat3(frame.view_from_world));
  vec3 geometric_vs = geometric_normal(pixel, depth, position_vs, normal_ws * world_from_view);
  float noise = screen_noise(uvec2(pixel), frame.frame_index, frame.seed);
  vec3 position_ws = world_from_view * position_vs;
  float hidden = sun_occlusion(position_ws, world_from_view * geometric_vs, noise);
  if (kContactShadows == 0u || hidden >= 1.0) return hidden;
  ContactReceiver receiver = contact_receiver_at(pixel, depth, position_ws, normal_ws);
  float texel_m = sun_texel(position_ws, noise);
  return max(hidden, 1.0 - contact_visibility(receiver, sun.axis_z.xyz, kUnboundedRadius, texel_m));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(vec2(pixel), frame.size.xy))) return;
  imageStore(occlusion, pixel, vec4(pixel_occlusion(pixel)));
}
