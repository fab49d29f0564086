#version 460
#extension GL_GOOGLE_include_directive : require

#include "shading/sampling.glsl"
#include "shading/tonemap.glsl"

// Every curve shows this as white, and the curves can square it.
const float kBrightest = 1e6f;

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

// Comparisons with what is not a number are false: it becomes 0.
float clean(float x) {
  return x > 0.0f ? min(x, kBrightest) : 0.0f;
}

vec3 displayed_light(vec4 premultiplied) {
  if (!(premultiplied.a > 0.0f)) return vec3(0.0f);
  vec3 light = premultiplied.rgb / premultiplied.a * exposure;
  return tonemap(kTonemap, vec3(clean(light.x), clean(light.y), clean(light.z)));
}

// x in [0, 1] to 16 bits. noise in [0, 1): 0.5 rounds to nearest; a uniform one makes the mean of many pixels right,
// and leaves values alone that 8 bits hold exactly, black and white among them.
uint quantize(float x, float noise) {
  if (kBits == 16u) return uint(x * 65535.0f + 0.5f);
  return min(uint(x * 255.0f + noise), 255u) * 257u;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(ivec2(pixel), imageSize(values)))) return;
  vec4 light = texelFetch(sum, ivec2(pixel), 0);
  float alpha = min(clean(light.a * frame_weight), 1.0f);
  vec3 linear = displayed_light(light);
  if (background.w > 0.0f) {
    linear = mix(background.rgb, linear, alpha);
    alpha = 1.0f;
  }
  vec3 encoded = clamp(srgb_encode(linear), 0.0f, 1.0f);
  // One noise for the three channels: greys stay grey.
  float noise = kDither ? screen_noise(pixel, 0u, seed) : 0.5f;
  imageStore(values, ivec2(pixel), uvec4(quantize(encoded.x, noise), quantize(encoded.y, noise),
                                         quantize(encoded.z, noise), quantize(alpha, 0.5f)));
}
