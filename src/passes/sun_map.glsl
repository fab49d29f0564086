// Soft shadows from one map of the sun: blocker search and filter, for every pass that keeps such maps
// (shading/shadow_filter.glsl). GLSL only.
#ifndef VEL_PASSES_SUN_MAP_GLSL
#define VEL_PASSES_SUN_MAP_GLSL

#include "gpu/samplers.glsl"
#include "passes/sun_map_io.glsl"
#include "shading/cascades.glsl"
#include "shading/contact_shadow.glsl"
#include "shading/shadow_bias.glsl"
#include "shading/shadow_filter.glsl"
#include "upload/frame.glsl"

// The radius of the smallest disc: what bilinear comparison smooths by itself.
const float kLeastKernel = 1.0;  // texels
// Stored depths are those of texel centres, half a diagonal away at most, and the search skips to the next ring.
const float kConeSlack = 1.5;  // texels
// What a point is lifted towards the sun before depths are compared: rounding of what the camera saw.
const float kDepthLift = 0.1;  // texels

// What the search found.
struct Blockers {
  uint hiding;     // taps whose blocker stands within the sun's cone, or beside it where none stands within
  uint nearer;     // taps whose depth is nearer to the sun at all
  float distance;  // mean of the former, metres
  float nearest;   // of those within the cone
  float farthest;
};

// A disc of a texel or two needs no more taps than show no steps.
bool is_sharp(Cascade c) {
  return c.soft.x < 2.0 * c.soft.z;
}

uint search_taps(Cascade c) {
  return is_sharp(c) ? kMinShadowTaps : kSunShadowTaps / 2u;
}

// A receiver as one map sees it.
struct SunReceiver {
  float layer;
  vec3 coord;  // shadow_coord()
  vec2 slope;  // how the depth of the receiver's own plane rises towards the sun, by u and v
};

// What a tap compares with: the receiver, and its own plane where that is nearer to the sun.
float receiver_depth(SunReceiver r, vec2 offset) {
  return r.coord.z + max(dot(r.slope, offset), 0.0);
}

// How far towards the sun what tap i of the search sees stands, metres; 0: it is no blocker.
float blocker_distance(texture2DArray depths, Cascade c, SunReceiver r, uint i, uint taps, vec2 direction) {
  vec2 offset = direction * search_tap_radius(i, taps, min(c.soft.z, c.soft.x), c.soft.x);
  float stored = textureLod(sampler2DArray(depths, nearest_sampler), vec3(r.coord.xy + offset, r.layer), 0.0).r;
  return stored > receiver_depth(r, offset) ? (stored - r.coord.z) * c.depth.z : 0.0;
}

// Does a blocker that tap i has found stand within the sun's cone, `width` times as wide?
bool stands_in_cone(Cascade c, uint i, uint taps, float distance, float width) {
  float radius = search_tap_radius(i, taps, min(c.soft.z, c.soft.x), c.soft.x);
  float cone = c.soft.x * penumbra_ratio_distant(distance, c.soft.y);
  return blocks_light(radius, width * cone, kConeSlack * c.soft.z);
}

Blockers find_blockers(texture2DArray depths, Cascade c, SunReceiver r, vec2 direction) {
  uint taps = search_taps(c);
  Blockers found = Blockers(0u, 0u, 0.0, c.soft.y, 0.0);
  vec2 within = vec2(0.0), beside = vec2(0.0);  // count and sum of distances
  uint i = 0u;
  do {
    float distance = blocker_distance(depths, c, r, i, taps, direction), counted = min(distance, c.soft.y);
    if (distance > 0.0) ++found.nearer;
    if (distance > 0.0 && stands_in_cone(c, i, taps, distance, kConeWidth)) beside += vec2(1.0, counted);
    if (distance > 0.0 && stands_in_cone(c, i, taps, distance, 1.0)) {
      within += vec2(1.0, counted);
      found.nearest = min(found.nearest, counted);
      found.farthest = max(found.farthest, counted);
    }
    direction = next_tap_direction(direction);
  } while (++i < taps);
  vec2 chosen = within.x > 0.0 ? within : beside;
  found.hiding = uint(chosen.x);
  found.distance = chosen.y / max(chosen.x, 1.0);
  return found;
}

// 1: nothing stands nearer to the sun than `depth`.
float pcf_tap(texture2DArray depths, SunReceiver r, vec2 offset, float depth) {
  return texture(sampler2DArrayShadow(depths, compare_sampler), vec4(r.coord.xy + offset, r.layer, depth));
}

float penumbra_ratio(Cascade c, float distance) {
  float least = min(kLeastKernel * c.soft.z / c.soft.x, 1.0);
  return max(penumbra_ratio_distant(distance, c.soft.y), least);
}

// Mean distances of the blockers before (x) and beyond (y) `split`, metres; those of one layer are all before it.
struct SunLayers {
  float split;  // 0: there is one layer
  vec2 distances;
};

SunLayers layers_of(texture2DArray depths, Cascade c, SunReceiver r, Blockers found, vec2 direction) {
  SunLayers layers = SunLayers(0.0, vec2(found.distance));
  if (!is_sharp(c) && are_layered(found.nearest, found.farthest)) {
    layers.split = layer_split(found.nearest, found.farthest);
    uint taps = search_taps(c);
    vec2 sum = vec2(0.0), count = vec2(0.0);
    uint i = 0u;
    do {
      float distance = blocker_distance(depths, c, r, i, taps, direction);
      bool counts = distance > 0.0 && stands_in_cone(c, i, taps, distance, 1.0);
      vec2 side = vec2(counts && distance < layers.split, counts && distance >= layers.split);
      sum += side * min(distance, c.soft.y);
      count += side;
      direction = next_tap_direction(direction);
    } while (++i < taps);
    layers.distances = sum / max(count, vec2(1.0));
  }
  return layers;
}

float layered_visibility(texture2DArray depths, Cascade c, SunReceiver r, SunLayers layers, vec2 direction) {
  float near_rho = penumbra_ratio(c, layers.distances.x), far_rho = penumbra_ratio(c, layers.distances.y);
  float far_depth = r.coord.z + layers.split * c.depth.x;
  uint taps = is_sharp(c) ? kMinShadowTaps : reduced_tap_count(far_rho, kSunShadowTaps);
  float scale = reduced_tap_scale(1.0, taps, kSunShadowTaps) * c.soft.x;
  LayeredRays rays = no_rays();
  uint i = 0u;
  do {
    vec2 ray = direction * (disc_tap_radius(i, kSunShadowTaps) * scale), near_uv = near_rho * ray;
    float past_near = pcf_tap(depths, r, near_uv, receiver_depth(r, near_uv)), past_far = 1.0, near_seen = 1.0;
    if (layers.split > 0.0) {
      past_far = pcf_tap(depths, r, far_rho * ray, far_depth);
      near_seen = pcf_tap(depths, r, near_uv, far_depth);
    }
    rays = with_ray(rays, past_far, near_seen, past_near);
    direction = next_tap_direction(direction);
  } while (++i < taps);
  return visibility_of(rays, taps);
}

// The share of the sun that is hidden. direction: of the first tap.
float map_occlusion(texture2DArray depths, Cascade c, SunReceiver r, vec2 direction) {
  Blockers found = find_blockers(depths, c, r, direction);
  float occlusion = found.hiding == 0u ? 0.0 : 1.0;
  if (found.hiding > 0u && found.nearer < search_taps(c))
    occlusion = 1.0 - layered_visibility(depths, c, r, layers_of(depths, c, r, found, direction), direction);
  return occlusion;
}

// A point of light space, and how it is lifted before it is looked up.
struct SunPoint {
  vec3 position, normal;  // normal: geometric, unit, of the lit side
  float eye_distance;     // metres
};

// Where a point is looked up in a map. texels: to lift it along its normal; snap: how far beside its plane a surface
// may be seen, pixels.
vec3 biased_coord(Cascade c, SunPoint p, float texels, float snap) {
  float seen_beside = snap * pixel_footprint(p.eye_distance, frame.ndc_to_view, frame.perspective, frame.size.y);
  float offset = max(shadow_normal_offset(p.normal.z, texels, c.depth.w), seen_beside);
  return shadow_coord(c, p.position + p.normal * offset + vec3(0.0, 0.0, kDepthLift * c.depth.w + c.soft.w));
}

#endif
