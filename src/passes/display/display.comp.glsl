#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "passes/display/display_io.glsl"
#include "shading/display.glsl"
#include "shading/sampling.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(ivec2(pixel), imageSize(values)))) return;
  vec4 light = texelFetch(frame_sum, ivec2(pixel), 0);
  float alpha = min(displayable(light.a * push.frame_weight), 1.0f);
  vec3 linear = displayed_light(kTonemap, light, exposure);
  if (push.background.w > 0.0f) {
    linear = mix(push.background.rgb, linear, alpha);
    alpha = 1.0f;
  }
  vec3 encoded = clamp(srgb_encode(linear), 0.0f, 1.0f);
  // One noise for the three channels: greys stay grey.
  float noise = kDither ? screen_noise(pixel, 0u, push.seed) : 0.5f;
  imageStore(values, ivec2(pixel), uvec4(quantize(encoded.x, noise, kBits), quantize(encoded.y, noise, kBits),
                                         quantize(encoded.z, noise, kBits), quantize(alpha, 0.5f, kBits)));
}
