#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

// How much of the sun is hidden from each pixel [Crytek, "Secrets of CryENGINE 3 Graphics Technology", 2011: deferred
// shadow mask]. What the sun cannot light anyway is left at 0: the sky, and surfaces that face away.

#include "passes/contact_shadows/read.glsl"
#include "passes/gbuffer/read_depth_buffer.glsl"
#include "passes/gbuffer/read_geometric_normal.glsl"
#include "passes/illumination.glsl"
#include "passes/sun_shadow_mask/sun_shadow_mask_out_io.glsl"
#include "shading/normal_encoding.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

float pixel_occlusion(ivec2 pixel) {
  float depth = linear_depth_at(pixel);
  if (depth == 0.0) return 0.0;
  vec3 normal_ws = bfn_decode(texelFetch(gbuffer_normal, pixel, 0).rgb);
  if (dot(normal_ws, sun.axis_z.xyz) <= 0.0) return 0.0;
  vec3 position_vs = position_at(pixel, depth);
  mat3 world_from_view = transpose(view_rotation());
  vec3 geometric_vs = geometric_normal(pixel, position_vs, normal_ws * world_from_view);
  float noise = screen_noise(uvec2(pixel), frame.frame_index, frame.seed);
  vec3 position_ws = world_from_view * position_vs + frame.eye.xyz;
  float hidden = sun_occlusion(position_ws, world_from_view * geometric_vs, noise);
  if (kContactSteps == 0u || hidden >= 1.0) return hidden;
  ContactReceiver receiver = contact_receiver_at(pixel, depth, position_ws, normal_ws);
  float texel_m = sun_texel(position_ws, noise, kBeyondCascades);
  return max(hidden, 1.0 - contact_visibility(receiver, sun.axis_z.xyz, kUnboundedRadius, texel_m));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(vec2(pixel), frame.size.xy))) return;
  imageStore(occlusion_out, pixel, vec4(pixel_occlusion(pixel)));
}
