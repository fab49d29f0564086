// One authored smoothness in [0, 1] and the GGX width alpha it stands for [Schulz 2014, Ryse].
#ifndef VEL_SHADING_SMOOTHNESS_GLSL
#define VEL_SHADING_SMOOTHNESS_GLSL

#include "shading/lang.glsl"

// The alpha of smoothness 1, (1 - 0.7)^6: the narrowest lobe that the G-buffer can hold.
const float kMinAlpha = 0.000729f;

// A punctual light has no size, so its highlight takes that of the sun: half its angular radius of 0.00465 rad, since
// the half vector turns half as fast as the light. Such a peak, 1 / (pi alpha^2) = 58888, still fits in fp16 (65504).
const float kMinAlphaPunctual = 0.002325f;

// alpha = (1 - 0.7 s)^6, s in [0, 1].
FN float alpha_from_smoothness(float smoothness) {
  require(smoothness >= 0.0f && smoothness <= 1.0f);
  float base = 1.0f - 0.7f * smoothness;
  float base2 = base * base;
  return base2 * base2 * base2;
}

// Inverse of alpha_from_smoothness; alphas outside [kMinAlpha, 1] saturate.
FN float smoothness_from_alpha(float alpha) {
  require(alpha >= 0.0f);
  return clamp((1.0f - pow(alpha, 1.0f / 6.0f)) / 0.7f, 0.0f, 1.0f);
}

// glTF 2.0, appendix B.2.1: alpha = perceptual_roughness^2.
FN float alpha_from_perceptual_roughness(float perceptual_roughness) {
  return perceptual_roughness * perceptual_roughness;
}

#endif
