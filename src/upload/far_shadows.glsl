// The sun's shadow where no cascade reaches, from one map of the whole scene. A part of upload/sun_shadows.glsl, which
// says what it uses. GLSL only.
#ifndef VEL_UPLOAD_FAR_SHADOWS_GLSL
#define VEL_UPLOAD_FAR_SHADOWS_GLSL

#include "shading/variance_shadow.glsl"

layout(constant_id = 15) const uint kFarSun = 0u;  // what there is beyond the cascades, as enum FarSun
const uint kFarNone = 0u;
const uint kFarMoments = 1u;  // layer 0: mean, layer 1: mean square of depth away from the sun, from the map's middle
const uint kFarStatic = 2u;   // depth, of what never moves

layout(set = 1, binding = 16) uniform sampler2DArray far_map;
layout(set = 1, binding = 17) uniform sampler2DArrayShadow far_comparison;  // of kFarStatic

// Of Chebyshev's bound this much may be wrong behind two blockers that stand one behind the other; what is below is dark.
const float kBleeding = 0.2;

// Filtered depths of a plane average to its own. What is left to lift it by, along its normal, is what the rasteriser may
// move it: up to a sixteenth of a texel on some devices.
const float kMomentLift = 0.125;  // texels

// Bilinear by hand: devices need not filter 32-bit floats.
vec2 moments_at(vec2 uv) {
  ivec2 last = textureSize(far_map, 0).xy - 1;
  vec2 texel = uv * vec2(last + 1) - 0.5;
  ivec2 corner = ivec2(floor(texel));
  vec2 share = texel - vec2(corner), moments = vec2(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(corner + step, ivec2(0), last);
    vec2 weights = mix(1.0 - share, share, vec2(step));
    vec2 stored = vec2(texelFetch(far_map, ivec3(at, 0), 0).r, texelFetch(far_map, ivec3(at, 1), 0).r);
    moments += weights.x * weights.y * stored;
  }
  return moments;
}

float moment_occlusion(Cascade c, vec3 place) {
  float deviation = c.soft.w * c.depth.x;
  float bound = chebyshev_bound(moments_at(place.xy), moment_depth(place.z), deviation * deviation);
  return 1.0 - without_bleeding(bound, kBleeding);
}

// p, n: of light space, the place and the geometric normal.
float far_occlusion(vec3 p, vec3 n, float noise) {
  if (kFarSun == kFarNone) return 0.0;
  Cascade c = sun.beyond;
  float lift = kFarSun == kFarMoments ? kMomentLift : sun.axis_z.w;
  vec3 place = lifted_place(c, p, n, lift);
  // Where the map ends there is nothing more to cast a shadow.
  bool beside = any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0)));
  if (beside || place.z >= 1.0) return 0.0;
  place.z = max(place.z, 0.0);
  if (kFarSun == kFarMoments) return moment_occlusion(c, place);
  SunReceiver r = SunReceiver(0.0, place, cascade_slope(c, n));
  return map_occlusion(far_map, far_comparison, c, r, first_tap_direction(noise));
}

#endif
