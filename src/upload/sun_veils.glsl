// What BLEND surfaces leave of the sun's light: read beside its maps of depth, with the same kernels
// (upload/sun_shadows.glsl). GLSL only; `frame` is the includer's.
#ifndef VEL_UPLOAD_SUN_VEILS_GLSL
#define VEL_UPLOAD_SUN_VEILS_GLSL

#include "upload/local_shadows.glsl"
#include "upload/sun_shadows.glsl"
#include "upload/veils.glsl"

layout(set = 1, binding = 15) uniform sampler2DArray sun_veils;  // nearest

// Half as many as opaque casters get, as contrasts are lower: FLIP of penumbrae of dye grows by a fiftieth.
const uint kSunVeilTaps = kShadowTaps / 2u;

vec4 sun_veil(SunReceiver r, vec2 offset) {
  return textureLod(sun_veils, vec3(r.place.xy + offset, r.layer), 0.0);
}

// Of the veils within the sun's cone, means: rgb what passes them; a how far towards the sun they stand, metres, 0 where
// there is none.
vec4 find_sun_veils(Cascade c, SunReceiver r, vec2 direction) {
  float found = 0.0;
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < kSunVeilTaps; ++i) {
    float radius = search_tap_radius(i, kSunVeilTaps, 0.0, c.soft.x);
    vec2 offset = direction * radius;
    vec4 veil = sun_veil(r, offset);
    float depth = receiver_depth(r, offset), distance = (veil.a - r.place.z) * c.depth.z;
    float cone = c.soft.x * penumbra_ratio_distant(distance, c.soft.y);
    if (veil.a > depth && blocks_light(radius, cone, kConeSlack * c.soft.z)) {
      found += 1.0;
      sum += vec4(past_veil(veil, depth), min(distance, c.soft.y));
    }
    direction = next_tap_direction(direction);
  }
  return sum / max(found, 1.0);
}

vec3 soft_sun_transmittance(Cascade c, SunReceiver r, vec2 direction) {
  vec4 found = find_sun_veils(c, r, direction);
  if (found.a == 0.0) return vec3(1.0);
  float rho = penumbra_ratio(c, found.a);
  uint taps = reduced_tap_count(rho, kSunVeilTaps);
  float scale = reduced_tap_scale(rho, taps, kSunVeilTaps) * c.soft.x;
  vec4 sum = kUnseenVeilWeight * vec4(found.rgb, 1.0);
  for (uint i = 0u; i < taps; ++i) {
    vec2 offset = direction * (disc_tap_radius(i, kSunVeilTaps) * scale);
    float seen = lit_share(sun_comparison, r, offset, r.place.z + found.a * c.depth.x);
    sum += seen * vec4(past_veil(sun_veil(r, offset), receiver_depth(r, offset)), 1.0);
    direction = next_tap_direction(direction);
  }
  return sum.rgb / sum.a;
}

// face_normal: of the receiver's plane, unit, of either side.
vec3 sun_transmittance(vec3 position_ws, vec3 face_normal) {
  float noise = screen_noise(pixel_of(position_ws), frame.frame_index, frame.seed);
  vec3 p = to_light_space(sun, position_ws);
  uint chosen = choose_cascade(p, noise);
  if ((sun.veiled >> chosen & 1u) == 0u) return vec3(1.0);
  Cascade c = sun.cascades[chosen];
  vec3 place = cascade_place(c, p);
  if (is_sharp(c)) return bilinear_veil(sun_veils, vec3(place.xy, chosen), place.z, true);
  vec3 lit_side = faceforward(face_normal, -sun.axis_z.xyz, face_normal);
  SunReceiver r = SunReceiver(float(chosen), place, cascade_slope(c, to_light_space(sun, lit_side)));
  return soft_sun_transmittance(c, r, first_tap_direction(noise));
}

#endif
