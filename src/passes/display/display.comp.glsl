#version 460
#extension GL_GOOGLE_include_directive : require

#include "shading/display.glsl"
#include "shading/sampling.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kTonemap = 0u;
layout(constant_id = 1) const uint kBits = 8u;
layout(constant_id = 2) const bool kDither = true;
layout(set = 0, binding = 0) uniform sampler2D sum;
layout(set = 0, binding = 1, std430) readonly buffer Exposure { float exposure; };
layout(set = 0, binding = 2, rgba16ui) writeonly uniform uimage2D values;
layout(push_constant) uniform Push {
  vec4 background;      // linear display light; w 1: lies behind, 0: there is none
  float frame_weight;
  uint seed;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(ivec2(pixel), imageSize(values)))) return;
  vec4 light = texelFetch(sum, ivec2(pixel), 0);
  float alpha = min(displayable(light.a * frame_weight), 1.0f);
  vec3 linear = displayed_light(kTonemap, light, exposure);
  if (background.w > 0.0f) {
    linear = mix(background.rgb, linear, alpha);
    alpha = 1.0f;
  }
  vec3 encoded = clamp(srgb_encode(linear), 0.0f, 1.0f);
  // One noise for the three channels: greys stay grey.
  float noise = kDither ? screen_noise(pixel, 0u, seed) : 0.5f;
  imageStore(values, ivec2(pixel), uvec4(quantize(encoded.x, noise, kBits), quantize(encoded.y, noise, kBits),
                                         quantize(encoded.z, noise, kBits), quantize(alpha, 0.5f, kBits)));
}
