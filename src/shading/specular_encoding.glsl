// Colours as (Y, Cb, Cr) of their square roots, so that 8 bits are enough for f0 [Schulz 2014, Ryse; CryENGINE].
// Y in [0, 1]; Cb, Cr in [-1/2, 1/2], 0 for grey. BT.709 weights, as luminance().
#ifndef VEL_SHADING_SPECULAR_ENCODING_GLSL
#define VEL_SHADING_SPECULAR_ENCODING_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"

// Chroma is stored with code 128 as zero; 127.5 is no code, and would tint every grey.
const float kChromaBias = 128.0f / 255.0f;

FN vec3 ycbcr_from_linear(vec3 linear) {
  vec3 q = sqrt(max(linear, vec3(0.0f)));
  float y = luminance(q);
  return vec3(y, (q.z - y) / 1.8556f, (q.x - y) / 1.5748f);
}

FN vec3 linear_from_ycbcr(vec3 ycbcr) {
  float r = ycbcr.x + 1.5748f * ycbcr.z;
  float b = ycbcr.x + 1.8556f * ycbcr.y;
  float g = (ycbcr.x - 0.2126f * r - 0.0722f * b) / 0.7152f;
  vec3 q = max(vec3(r, g, b), vec3(0.0f));
  return q * q;
}

// f0, linear 0..1 -> what to store in UNORM8. Worst error after rounding: 0.0055 in sqrt(f0).
FN vec3 specular_encode(vec3 f0) {
  vec3 ycbcr = ycbcr_from_linear(f0);
  return clamp(vec3(ycbcr.x, ycbcr.y + kChromaBias, ycbcr.z + kChromaBias), 0.0f, 1.0f);
}

FN vec3 specular_decode(vec3 stored) {
  return linear_from_ycbcr(vec3(stored.x, stored.y - kChromaBias, stored.z - kChromaBias));
}

#endif
