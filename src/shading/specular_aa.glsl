// Normals that vary within what a pixel sees, as width of the GGX lobe [Toksvig 2004; Hill & Baker 2012; Schulz 2014,
// Ryse]. Normals that are Gaussian about their mean with variance v along each axis (radians^2) turn a lobe of width
// alpha into one of alpha'^2 = alpha^2 + 2 v: a GGX lobe is near its peak as a Gaussian of variance alpha^2 / 2.
// 2 v is called `spread2` here, its root `spread`: the alpha of a lobe as high as the normals alone would make.
#ifndef VEL_SHADING_SPECULAR_AA_GLSL
#define VEL_SHADING_SPECULAR_AA_GLSL

#include "shading/lang.glsl"
#include "shading/smoothness.glsl"

// From the length of the mean of unit normals, 0..1, that a texel of a smaller mip stands for [Toksvig 2004:
// v = (1 - r) / r]. A spread of 1 is that of an alpha of 1, and the most that 8 bits hold.
FN float spread_from_mean_length(float mean_length) {
  require(mean_length >= 0.0f);
  float r = max(mean_length, 1e-6f);
  return sqrt(clamp(2.0f * (1.0f - r) / r, 0.0f, 1.0f));
}

// From the length of the mean of some unit normals on the screen: v = 1 / kappa of the von Mises-Fisher lobe of that
// mean [Banerjee et al. 2005, kappa = (3 r - r^3) / (1 - r^2)]. Agrees with Toksvig's for small v; is less for large.
FN float spread2_from_screen_mean(float mean_length) {
  require(mean_length >= 0.0f);
  float r = clamp(mean_length, 1e-3f, 1.0f);
  float r2 = r * r;
  return 2.0f * (1.0f - r2) / (r * (3.0f - r2));
}

// The mean of four unit normals of neighbouring texels has length r, 0..1. What lies between the texels is interpolated,
// which leaves less of their spread: of the variance of four texels a bilinear filter takes 2/3 where they are parts of
// something smooth, 0.74 where they have nothing to do with each other. Returns the length of the mean of all that the
// filter shows between them.
FN float interpolated_mean_length(float mean_length) {
  require(mean_length >= 0.0f);
  const float kTaken = 0.7f;
  return mix(min(mean_length, 1.0f), 1.0f, kTaken);
}

// What the filter does not show of those four, as the length of a mean. Lengths multiply as variances add: a texel whose
// own is r has r times this one's spread, so that level by level normals and spread together hold the same variance.
FN float interpolation_gap(float mean_length) {
  return min(mean_length, 1.0f) / interpolated_mean_length(mean_length);
}

// spread2 >= 0. Nothing is wider than alpha 1.
//
// A factor of 2 to v fits a lobe's core; but where normals spread by more than the lobe is wide, the sum is nearer to a
// Gaussian, and GGX's tails, as wide as the core, take light to where there is none. The factor is the one that
// misplaces least light, the integral of |D' - D convolved|: 2.1 for wide lobes, 1.5 for narrow ones, fitted in between.
FN float widened_alpha(float alpha, float spread2) {
  require(spread2 >= 0.0f);
  float a2 = alpha * alpha;
  float factor = 0.75f + 0.3f * a2 / max(a2 + 0.125f * spread2, 1e-12f);   // of 2 v
  return sqrt(min(a2 + factor * spread2, 1.0f));
}

FN float widened_smoothness(float smoothness, float spread2) {
  return smoothness_from_alpha(widened_alpha(alpha_from_smoothness(smoothness), spread2));
}

// The screen-space filter looks at a pixel and its four neighbours. Rough surfaces gain nothing from it [CryENGINE].
const float kScreenFilterLeastSmoothness = 0.3f;

// The most that it adds to alpha^2 [Tokuyoshi & Kaplanyan 2019, the usual clamp]: what turns farther is an edge.
const float kScreenMostSpread2 = 0.18f;

// Five taps at distances 0, 0, 0, 1, 1 of an axis have a variance of 2/5 pixel^2, the square of one pixel has 1/12: of
// normals that turn evenly the filter sees so many times more than the pixel. (CryENGINE's 1/4 is near.)
const float kScreenShare = 5.0f / 24.0f;

// How much a neighbour counts whose view depth is `step_m` metres off the surface of a pixel `depth_m` away: nothing
// from 0.25 m on [CryENGINE], which far away, where pixels are large, grows with the distance.
FN float screen_tap_weight(float step_m, float depth_m) {
  return 1.0f - clamp(4.0f * step_m / max(1.0f, 0.05f * depth_m), 0.0f, 1.0f);
}

// Lower reflectance of dielectrics that were widened hides the outlines that the filter leaves at edges [Schulz 2014,
// "specular aliasing": luma *= (s' + eps) / (s + eps)]; what is brighter is metal [CryENGINE: 0.05].
// specular_y: Y of specular_encode(), the root of the luma.
FN float dimmed_specular_y(float specular_y, float smoothness, float widened) {
  const float kMostLuma = 0.05f, kEpsilon = 1e-4f;
  if (specular_y * specular_y >= kMostLuma) return specular_y;
  return specular_y * sqrt((widened + kEpsilon) / (smoothness + kEpsilon));
}

#endif
