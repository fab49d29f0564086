#ifndef VEL_SHADING_COLOR_GLSL
#define VEL_SHADING_COLOR_GLSL

#include "shading/lang.glsl"

// Relative luminance of linear BT.709 primaries [ITU-R BT.709-6, 3.3].
FN float luminance(vec3 rgb) {
  return dot(rgb, vec3(0.2126f, 0.7152f, 0.0722f));
}

FN float max_component(vec3 v) {
  return max(v.x, max(v.y, v.z));
}

FN float min_component(vec3 v) {
  return min(v.x, min(v.y, v.z));
}

FN float srgb_encode_channel(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * pow(linear, 1.0f / 2.4f) - 0.055f;
}

FN float srgb_decode_channel(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : pow((encoded + 0.055f) / 1.055f, 2.4f);
}

// Linear light -> sRGB code values [IEC 61966-2-1]. Negative input becomes 0; above 1 the curve goes on.
FN vec3 srgb_encode(vec3 linear) {
  vec3 v = max(linear, vec3(0.0f));
  return vec3(srgb_encode_channel(v.x), srgb_encode_channel(v.y), srgb_encode_channel(v.z));
}

// sRGB code values -> linear light, the inverse of srgb_encode.
FN vec3 srgb_decode(vec3 encoded) {
  vec3 v = max(encoded, vec3(0.0f));
  return vec3(srgb_decode_channel(v.x), srgb_decode_channel(v.y), srgb_decode_channel(v.z));
}

#endif
