// The last step of a picture: scene light to the code values of a display.
#ifndef VEL_SHADING_DISPLAY_GLSL
#define VEL_SHADING_DISPLAY_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"
#include "shading/tonemap.glsl"

// Every curve shows this as white, and the curves can square it.
const float kBrightest = 1e6f;

// Darker than the smallest normal half, 2^-14, light has lost its digits, and its logarithm would outweigh the rest.
const float kNearBlack = 1.0f / 16384.0f;

// No sum of halves comes near to this: it has overflowed.
const float kOverflow = 1e30f;

// What a picture's geometric mean is shown as: the reflectance of middle grey [Reinhard et al. 2002, eqs. 1 and 2].
const float kMiddleGrey = 0.18f;

// Within [0, kBrightest]. Comparisons with what is not a number are false: it becomes 0.
FN float displayable(float x) {
  return x > 0.0f ? min(x, kBrightest) : 0.0f;
}

// Linear display light of one pixel, straight. premultiplied: light and coverage, times any common factor.
FN vec3 displayed_light(uint curve, vec4 premultiplied, float exposure) {
  if (!(premultiplied.w > 0.0f)) return vec3(0.0f);
  vec3 light = vec3(premultiplied.x, premultiplied.y, premultiplied.z) / premultiplied.w * exposure;
  return tonemap(curve, vec3(displayable(light.x), displayable(light.y), displayable(light.z)));
}

// x in [0, 1] to 16 bits; at 8 bits to multiples of 257. noise in [0, 1): 0.5 rounds to nearest; a uniform one makes
// the mean of many pixels right, and leaves values alone that 8 bits hold exactly, black and white among them.
FN uint quantize(float x, float noise, uint bits) {
  if (bits == 16u) return uint(x * 65535.0f + 0.5f);
  return min(uint(x * 255.0f + noise), 255u) * 257u;
}

// A pixel's part of the mean log luminance: (coverage * log2, coverage); nothing where there is no light to adapt to.
// light: mean of the pixel's frames, premultiplied.
FN vec2 weighted_log2_luminance(vec4 premultiplied) {
  float coverage = premultiplied.w;
  float light = luminance(vec3(premultiplied.x, premultiplied.y, premultiplied.z) / coverage);
  // What is not a number is left out.
  bool counts = coverage > 0.0f && light > kNearBlack && light < kOverflow;
  return counts ? coverage * vec2(log2(light), 1.0f) : vec2(0.0f);
}

// What brings the geometric mean of a picture to kMiddleGrey. sum: of weighted_log2_luminance. 1 for nothing but black.
FN float automatic_exposure(vec2 sum) {
  return sum.y > 0.0f ? kMiddleGrey / exp2(sum.x / sum.y) : 1.0f;
}

#endif
