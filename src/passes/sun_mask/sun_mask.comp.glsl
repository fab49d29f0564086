#version 460
#extension GL_GOOGLE_include_directive : require

// How much of the sun is hidden from each pixel [Crytek, "Secrets of CryENGINE 3 Graphics Technology", 2011: deferred
// shadow mask]. What the sun cannot light anyway is left at 0: the sky, and surfaces that face away.

#include "shading/normal_encoding.glsl"
#include "shading/sampling.glsl"
#include "upload/gpu_structs.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, std430) readonly buffer FrameBuffer { FrameUniforms frame; };
layout(set = 0, binding = 1) uniform sampler2D rt0;
layout(set = 0, binding = 4) uniform sampler2D depth_map;
layout(set = 0, binding = 6, r32f) writeonly uniform image2D occlusion;

#include "upload/contact_shadows.glsl"
#include "upload/geometric_normal.glsl"
#include "upload/picture_depth.glsl"
#include "upload/sun_shadows.glsl"

float pixel_occlusion(ivec2 pixel) {
  float depth = depth_at(pixel);
  if (depth == 0.0) return 0.0;
  vec3 normal_ws = bfn_decode(texelFetch(rt0, pixel, 0).rgb);
  if (dot(normal_ws, sun.axis_z.xyz) <= 0.0) return 0.0;
  vec3 position_vs = position_at(pixel, depth);
  mat3 world_from_view = transpose(mat3(frame.view_from_world));
  vec3 geometric_vs = geometric_normal(pixel, position_vs, normal_ws * world_from_view);
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
