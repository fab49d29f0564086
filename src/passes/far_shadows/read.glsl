// The sun's shadow where no cascade reaches, from one map of the whole scene. GLSL only.
#ifndef VEL_PASSES_FAR_SHADOWS_READ_GLSL
#define VEL_PASSES_FAR_SHADOWS_READ_GLSL

#include "passes/far_shadows/far_shadows_io.glsl"
#include "passes/sun_map.glsl"
#include "shading/variance_shadow.glsl"

// Of Chebyshev's bound this much may be wrong behind two blockers that stand one behind the other; what is below is dark.
const float kBleeding = 0.2;

// Filtered depths of a plane average to its own. What is left to lift it by, along its normal, is what the rasteriser may
// move it: up to a sixteenth of a texel on some devices.
const float kVarianceLift = 0.125;  // texels

// Bilinear by hand: devices need not filter 32-bit floats.
vec2 moments_at(vec2 uv) {
  ivec2 last = textureSize(far_moments, 0).xy - 1;
  vec2 texel = uv * vec2(last + 1) - 0.5;
  ivec2 corner = ivec2(floor(texel));
  vec2 share = texel - vec2(corner), moments = vec2(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(corner + step, ivec2(0), last);
    vec2 weights = mix(1.0 - share, share, vec2(step));
    vec2 stored = vec2(texelFetch(far_moments, ivec3(at, 0), 0).r, texelFetch(far_moments, ivec3(at, 1), 0).r);
    moments += weights.x * weights.y * stored;
  }
  return moments;
}

float variance_occlusion(Cascade c, vec3 coord) {
  float deviation = c.soft.w * c.depth.x;
  float bound = chebyshev_bound(moments_at(coord.xy), moment_depth(coord.z), deviation * deviation);
  return 1.0 - without_bleeding(bound, kBleeding);
}

// The share of the sun that is hidden by what the far map holds.
float far_occlusion(SunPoint p, float noise) {
  if (kFarShadow == kNoFarShadow) return 0.0;
  Cascade c = far.cascade;
  float lift = kFarShadow == kFarVariance ? kVarianceLift : far.normal_offset;
  vec3 coord = biased_coord(c, p, lift, far.snap);
  // Where the map ends there is nothing more to cast a shadow.
  bool beside = any(lessThan(coord.xy, vec2(0.0))) || any(greaterThan(coord.xy, vec2(1.0)));
  if (beside || coord.z >= 1.0) return 0.0;
  coord.z = max(coord.z, 0.0);
  if (kFarShadow == kFarVariance) return variance_occlusion(c, coord);
  SunReceiver r = SunReceiver(0.0, coord, cascade_slope(c, p.normal));
  return map_occlusion(far_depths, c, r, first_tap_direction(noise));
}

#endif
