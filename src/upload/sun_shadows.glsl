// The sun's shadow at a point, from its cascades: shared by the mask of opaque surfaces and by transparent ones. GLSL only.
#ifndef VEL_UPLOAD_SUN_SHADOWS_GLSL
#define VEL_UPLOAD_SUN_SHADOWS_GLSL

#include "shading/cascades.glsl"
#include "shading/shadow_bias.glsl"
#include "shading/shadow_filter.glsl"
#include "upload/shadow_taps.glsl"

layout(set = 1, binding = 9) uniform sampler2DArray sun_depths;
layout(set = 1, binding = 10) uniform sampler2DArrayShadow sun_comparison;  // 1: nothing nearer to the sun
layout(set = 1, binding = 11, std430) readonly buffer SunBuffer { SunShadows sun; };

// The radius of the smallest disc: what bilinear comparison smooths by itself.
const float kLeastKernel = 1.0;  // texels
// Stored depths are those of texel centres, half a diagonal away at most, and the search skips to the next ring.
const float kConeSlack = 1.5;    // texels
// What a point is lifted towards the sun before depths are compared: rounding of what the camera saw.
const float kDepthLift = 0.1;    // texels

// What the search found.
struct Blockers {
  uint hiding;     // taps whose blocker stands within the sun's cone
  uint nearer;     // taps whose depth is nearer to the sun at all
  float distance;  // mean of the former, metres
};

// A disc of a texel or two needs no more taps than show no steps.
bool is_sharp(Cascade c) {
  return c.soft.x < 2.0 * c.soft.z;
}

uint search_taps(Cascade c) {
  return is_sharp(c) ? kMinShadowTaps : kShadowTaps / 2u;
}

Blockers find_blockers(sampler2DArray depths, Cascade c, float layer, vec3 place, vec2 direction) {
  uint taps = search_taps(c);
  Blockers found = Blockers(0u, 0u, 0.0);
  uint i = 0u;
  do {
    float radius = search_tap_radius(i, taps, min(c.soft.z, c.soft.x), c.soft.x);
    float stored = textureLod(depths, vec3(place.xy + direction * radius, layer), 0.0).r;
    float distance = (stored - place.z) * c.depth.z;
    float cone = c.soft.x * penumbra_ratio_distant(distance, c.soft.y);
    if (distance > 0.0) ++found.nearer;
    if (distance > 0.0 && blocks_light(radius, cone, kConeSlack * c.soft.z)) {
      ++found.hiding;
      found.distance += min(distance, c.soft.y);
    }
    direction = next_tap_direction(direction);
  } while (++i < taps);
  found.distance /= float(max(found.hiding, 1u));
  return found;
}

// The share of the sun that is hidden. place: cascade_place() of the point. direction: of the first tap.
float map_occlusion(sampler2DArray depths, sampler2DArrayShadow comparison, Cascade c, float layer, vec3 place,
                    vec2 direction) {
  Blockers found = find_blockers(depths, c, layer, place, direction);
  if (found.hiding == 0u) return 0.0;
  if (found.nearer == search_taps(c)) return 1.0;
  float least = min(kLeastKernel * c.soft.z / c.soft.x, 1.0);
  float rho = max(penumbra_ratio_distant(found.distance, c.soft.y), least);
  uint taps = is_sharp(c) ? kMinShadowTaps : reduced_tap_count(rho, kShadowTaps);
  float scale = reduced_tap_scale(rho, taps, kShadowTaps) * c.soft.x;
  float lit = 0.0;
  uint i = 0u;
  do {
    float radius = disc_tap_radius(i, kShadowTaps) * scale;
    float clearance = tap_clearance(radius / (rho * c.soft.x), found.distance) * c.depth.x;
    lit += texture(comparison, vec4(place.xy + direction * radius, layer, place.z + clearance));
    direction = next_tap_direction(direction);
  } while (++i < taps);
  return 1.0 - lit / float(taps);
}

// Where to look a point up. p, n: of light space, the place and the geometric normal; texels: to lift it along that.
vec3 lifted_place(Cascade c, vec3 p, vec3 n, float texels) {
  float offset = shadow_normal_offset(n.z, texels, c.depth.w);
  return cascade_place(c, p + n * offset + vec3(0.0, 0.0, kDepthLift * c.depth.w + c.soft.w));
}

#include "upload/far_shadows.glsl"

// The finest map that holds the point, or, towards its border, the next one by noise; sun.cascade_count where none does,
// and by noise where there is a far map beyond the last.
// Loops here have one way out, at their end: drivers that run pixels in lockstep lose track of others.
uint choose_cascade(vec3 p_ls, float noise) {
  uint chosen = sun.cascade_count;
  for (uint i = sun.cascade_count; i > 0u; --i) {
    Cascade c = sun.cascades[i - 1u];
    float weight = cascade_weight(c, cascade_place(c, p_ls));
    bool last = i == sun.cascade_count && kFarSun == kFarNone;
    if (last ? weight > 0.0 : weight > noise) chosen = i - 1u;
  }
  return chosen;
}

// Side of a texel of the cascade that a point is looked up in, metres; 0 beyond all of them.
float sun_texel(vec3 position, float noise) {
  uint chosen = choose_cascade(to_light_space(sun, position), noise);
  return chosen == sun.cascade_count ? 0.0 : sun.cascades[chosen].depth.w;
}

// position: world axes, relative to the eye; normal: geometric, unit, of the lit side; noise: in [0, 1).
float sun_occlusion(vec3 position, vec3 normal, float noise) {
  vec3 p = to_light_space(sun, position);
  vec3 n = to_light_space(sun, normal);
  uint chosen = choose_cascade(p, noise);
  if (chosen == sun.cascade_count) return far_occlusion(p, n, noise);
  Cascade c = sun.cascades[chosen];
  vec3 place = lifted_place(c, p, n, sun.axis_z.w);
  return map_occlusion(sun_depths, sun_comparison, c, float(chosen), place, first_tap_direction(noise));
}

#endif
