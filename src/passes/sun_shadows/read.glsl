// The sun's shadow at a point, from its cascades. GLSL only.
#ifndef VEL_PASSES_SUN_SHADOWS_READ_GLSL
#define VEL_PASSES_SUN_SHADOWS_READ_GLSL

#include "passes/sun_map.glsl"
#include "passes/sun_shadows/sun_shadows_io.glsl"
#include "passes/translucency_map.glsl"
#include "shading/sampling.glsl"

// The finest map that holds the point, or, towards its border, the next one by noise; sun.cascade_count where none does,
// and by noise where there is a map beyond the last.
// Loops here have one way out, at their end: drivers that run pixels in lockstep lose track of others.
uint choose_cascade(vec3 p_ls, float noise, bool beyond) {
  uint chosen = sun.cascade_count;
  for (uint i = sun.cascade_count; i > 0u; --i) {
    Cascade c = sun.cascades[i - 1u];
    float weight = cascade_weight(c, shadow_coord(c, p_ls));
    bool last = i == sun.cascade_count && !beyond;
    if (last ? weight > 0.0 : weight > noise) chosen = i - 1u;
  }
  return chosen;
}

// Side of a texel of the cascade that a point is looked up in, metres; 0 beyond all of them.
float sun_texel(vec3 position, float noise, bool beyond) {
  uint chosen = choose_cascade(to_light_space(sun, position), noise, beyond);
  return chosen == sun.cascade_count ? 0.0 : sun.cascades[chosen].depth.w;
}

// position, normal: world space.
SunPoint sun_point(vec3 position, vec3 normal) {
  SunPoint p;
  p.position = to_light_space(sun, position);
  p.normal = to_light_space(sun, normal);
  p.eye_distance = length(p.position - to_light_space(sun, frame.eye.xyz));
  return p;
}

// The share of the sun that is hidden by what cascade `chosen` holds.
float cascade_occlusion(uint chosen, SunPoint p, float noise) {
  Cascade c = sun.cascades[chosen];
  SunReceiver r = SunReceiver(float(chosen), biased_coord(c, p, sun.axis_z.w, sun.axis_x.w), cascade_slope(c, p.normal));
  return map_occlusion(sun_depths, c, r, first_tap_direction(noise));
}

// Half as many as opaque casters get, as contrasts are lower: FLIP of penumbrae of dye grows by a fiftieth.
const uint kSunTranslucencyTaps = kSunShadowTaps / 2u;

vec4 sun_translucency_at(SunReceiver r, vec2 offset) {
  return textureLod(sampler2DArray(sun_translucency, nearest_sampler), vec3(r.coord.xy + offset, r.layer), 0.0);
}

// Means over the BLEND surfaces within the sun's cone: rgb what passes them; a how far towards the sun they stand, metres,
// 0 where there is none.
vec4 find_sun_translucency(Cascade c, SunReceiver r, vec2 direction) {
  float found = 0.0;
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < kSunTranslucencyTaps; ++i) {
    float radius = search_tap_radius(i, kSunTranslucencyTaps, 0.0, c.soft.x);
    vec2 offset = direction * radius;
    vec4 texel = sun_translucency_at(r, offset);
    float depth = receiver_depth(r, offset), distance = (texel.a - r.coord.z) * c.depth.z;
    float cone = c.soft.x * penumbra_ratio_distant(distance, c.soft.y);
    if (texel.a > depth && blocks_light(radius, cone, kConeSlack * c.soft.z)) {
      found += 1.0;
      sum += vec4(map_transmittance(texel, depth), min(distance, c.soft.y));
    }
    direction = next_tap_direction(direction);
  }
  return sum / max(found, 1.0);
}

vec3 soft_sun_transmittance(Cascade c, SunReceiver r, vec2 direction) {
  vec4 found = find_sun_translucency(c, r, direction);
  if (found.a == 0.0) return vec3(1.0);
  float rho = penumbra_ratio(c, found.a);
  uint taps = reduced_tap_count(rho, kSunTranslucencyTaps);
  float scale = reduced_tap_scale(rho, taps, kSunTranslucencyTaps) * c.soft.x;
  vec4 sum = kUnseenTranslucencyWeight * vec4(found.rgb, 1.0);
  for (uint i = 0u; i < taps; ++i) {
    vec2 offset = direction * (disc_tap_radius(i, kSunTranslucencyTaps) * scale);
    float seen = pcf_tap(sun_depths, r, offset, r.coord.z + found.a * c.depth.x);
    sum += seen * vec4(map_transmittance(sun_translucency_at(r, offset), receiver_depth(r, offset)), 1.0);
    direction = next_tap_direction(direction);
  }
  return sum.rgb / sum.a;
}

// face_normal: of the receiver's plane, unit, of either side.
vec3 sun_transmittance(vec3 position_ws, vec3 face_normal, bool beyond) {
  float noise = screen_noise(pixel_of(position_ws), frame.frame_index, frame.seed);
  vec3 p = to_light_space(sun, position_ws);
  uint chosen = choose_cascade(p, noise, beyond);
  if ((sun.translucent >> chosen & 1u) == 0u) return vec3(1.0);
  Cascade c = sun.cascades[chosen];
  vec3 coord = shadow_coord(c, p);
  if (is_sharp(c)) return bilinear_transmittance(sun_translucency, vec3(coord.xy, chosen), coord.z, true);
  vec3 lit_side = faceforward(face_normal, -sun.axis_z.xyz, face_normal);
  SunReceiver r = SunReceiver(float(chosen), coord, cascade_slope(c, to_light_space(sun, lit_side)));
  return soft_sun_transmittance(c, r, first_tap_direction(noise));
}

#endif
