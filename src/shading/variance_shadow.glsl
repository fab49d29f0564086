// Shadows from the mean and the mean square of depth [Donnelly & Lauritzen 2006, "Variance Shadow Maps"]. Unlike depth,
// these may be filtered before they are compared: a blurred map gives soft shadows by one look.
//
// Depths here grow away from the light. Their origin and unit are the caller's, one a map; rounding is least where the
// origin lies in the middle of the map.
#ifndef VEL_SHADING_VARIANCE_SHADOW_GLSL
#define VEL_SHADING_VARIANCE_SHADOW_GLSL

#include "shading/lang.glsl"

// From reversed depth of 0 to 1: from -1/2, nearest to the light, to 1/2.
FN float moment_depth(float reversed_depth) {
  return 0.5f - reversed_depth;
}

// What a filter averages.
FN vec2 depth_moments(float depth) {
  return vec2(depth, depth * depth);
}

// The largest share of the filtered depths that may lie at `depth` or behind it, hence of the light that may arrive
// there: Chebyshev's inequality, one-sided [ibid., eq. 5]. It is exact for two depths of which one is `depth`, a plane
// before a plane. moments: filtered depth_moments(); least_variance: of what is taken for one surface, > 0.
FN float chebyshev_bound(vec2 moments, float depth, float least_variance) {
  require(least_variance > 0.0f);
  float behind = depth - moments.x;
  if (behind <= 0.0f) return 1.0f;
  float variance = max(moments.y - moments.x * moments.x, least_variance);
  return variance / (variance + behind * behind);
}

// The bound is no more than that: behind two blockers, one behind the other, some light seems to arrive. Taking all that
// is less than `bleeding` for none hides it, for shadows a little wider [Lauritzen 2007, GPU Gems 3, chapter 8.4.3].
FN float without_bleeding(float bound, float bleeding) {
  require(bleeding >= 0.0f && bleeding < 1.0f);
  return clamp((bound - bleeding) / (1.0f - bleeding), 0.0f, 1.0f);
}

// Weight of a texel `offset` from the middle of a blur, not normalised. deviation: of the bell curve, texels.
FN float blur_weight(float offset, float deviation) {
  require(deviation > 0.0f);
  float x = offset / deviation;
  return exp2(-0.72134752f * x * x);  // log2(e) / 2
}

#endif
