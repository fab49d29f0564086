// The sun's shadow at a point, from its cascades: shared by the mask of opaque surfaces and by transparent ones. GLSL only.
// The includer defines, before: FrameUniforms frame.
#ifndef VEL_UPLOAD_SUN_SHADOWS_GLSL
#define VEL_UPLOAD_SUN_SHADOWS_GLSL

#include "shading/cascades.glsl"
#include "shading/contact_shadow.glsl"
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
  uint hiding;      // taps whose blocker stands within the sun's cone, or beside it where none stands within
  uint nearer;      // taps whose depth is nearer to the sun at all
  float distance;   // mean of the former, metres
  float nearest;    // of those within the cone
  float farthest;
};

// A disc of a texel or two needs no more taps than show no steps.
bool is_sharp(Cascade c) {
  return c.soft.x < 2.0 * c.soft.z;
}

uint search_taps(Cascade c) {
  return is_sharp(c) ? kMinShadowTaps : kShadowTaps / 2u;
}

// A receiver as one map sees it.
struct SunReceiver {
  float layer;
  vec3 place;   // cascade_place()
  vec2 slope;   // how the depth of the receiver's own plane rises towards the sun, by u and v
};

// What a tap compares with: the receiver, and its own plane where that is nearer to the sun.
float receiver_depth(SunReceiver r, vec2 offset) {
  return r.place.z + max(dot(r.slope, offset), 0.0);
}

// How far towards the sun what tap i of the search sees stands, metres; 0: it is no blocker.
float blocker_distance(sampler2DArray depths, Cascade c, SunReceiver r, uint i, uint taps, vec2 direction) {
  vec2 offset = direction * search_tap_radius(i, taps, min(c.soft.z, c.soft.x), c.soft.x);
  float stored = textureLod(depths, vec3(r.place.xy + offset, r.layer), 0.0).r;
  return stored > receiver_depth(r, offset) ? (stored - r.place.z) * c.depth.z : 0.0;
}

// Does a blocker that tap i has found stand within the sun's cone, `width` times as wide?
bool stands_in_cone(Cascade c, uint i, uint taps, float distance, float width) {
  float radius = search_tap_radius(i, taps, min(c.soft.z, c.soft.x), c.soft.x);
  float cone = c.soft.x * penumbra_ratio_distant(distance, c.soft.y);
  return blocks_light(radius, width * cone, kConeSlack * c.soft.z);
}

Blockers find_blockers(sampler2DArray depths, Cascade c, SunReceiver r, vec2 direction) {
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
float lit_share(sampler2DArrayShadow comparison, SunReceiver r, vec2 offset, float depth) {
  return texture(comparison, vec4(r.place.xy + offset, r.layer, depth));
}

float penumbra_ratio(Cascade c, float distance) {
  float least = min(kLeastKernel * c.soft.z / c.soft.x, 1.0);
  return max(penumbra_ratio_distant(distance, c.soft.y), least);
}

// Mean distances of the blockers before (x) and beyond (y) `split`, metres; those of one layer are all before it.
struct SunLayers {
  float split;   // 0: there is one layer
  vec2 distances;
};

SunLayers layers_of(sampler2DArray depths, Cascade c, SunReceiver r, Blockers found, vec2 direction) {
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

float layered_visibility(sampler2DArrayShadow comparison, Cascade c, SunReceiver r, SunLayers layers, vec2 direction) {
  float near_rho = penumbra_ratio(c, layers.distances.x), far_rho = penumbra_ratio(c, layers.distances.y);
  float far_depth = r.place.z + layers.split * c.depth.x;
  uint taps = is_sharp(c) ? kMinShadowTaps : reduced_tap_count(far_rho, kShadowTaps);
  float scale = reduced_tap_scale(1.0, taps, kShadowTaps) * c.soft.x;
  LayeredRays rays = no_rays();
  uint i = 0u;
  do {
    vec2 ray = direction * (disc_tap_radius(i, kShadowTaps) * scale), near_uv = near_rho * ray;
    float past_near = lit_share(comparison, r, near_uv, receiver_depth(r, near_uv)), past_far = 1.0, near_seen = 1.0;
    if (layers.split > 0.0) {
      past_far = lit_share(comparison, r, far_rho * ray, far_depth);
      near_seen = lit_share(comparison, r, near_uv, far_depth);
    }
    rays = with_ray(rays, past_far, near_seen, past_near);
    direction = next_tap_direction(direction);
  } while (++i < taps);
  return visibility_of(rays, taps);
}

// The share of the sun that is hidden. direction: of the first tap.
float map_occlusion(sampler2DArray depths, sampler2DArrayShadow comparison, Cascade c, SunReceiver r, vec2 direction) {
  Blockers found = find_blockers(depths, c, r, direction);
  float occlusion = found.hiding == 0u ? 0.0 : 1.0;
  if (found.hiding > 0u && found.nearer < search_taps(c))
    occlusion = 1.0 - layered_visibility(comparison, c, r, layers_of(depths, c, r, found, direction), direction);
  return occlusion;
}

// Where to look a point up. p, n: of light space, the place and the geometric normal; texels: to lift it along that.
vec3 lifted_place(Cascade c, vec3 p, vec3 n, float texels) {
  float seen_beside = sun.axis_x.w * pixel_footprint(length(p), frame.ndc_to_view, frame.perspective, frame.size.y);
  float offset = max(shadow_normal_offset(n.z, texels, c.depth.w), seen_beside);
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

// Whatever normal maps say, what is turned away from the sun by more than this cosine is dark. Nothing nearer to 0, as
// normals that are taken from depths are rough at outlines: the boxes under a sun lose by -0.1, the courtyard gains until -0.03.
const float kFacesAway = -0.15;

// position: world axes, relative to the eye; normal: geometric, unit, of the lit side; noise: in [0, 1).
float sun_occlusion(vec3 position, vec3 normal, float noise) {
  vec3 p = to_light_space(sun, position);
  vec3 n = to_light_space(sun, normal);
  if (n.z < kFacesAway) return 1.0;
  uint chosen = choose_cascade(p, noise);
  if (chosen == sun.cascade_count) return far_occlusion(p, n, noise);
  Cascade c = sun.cascades[chosen];
  SunReceiver r = SunReceiver(float(chosen), lifted_place(c, p, n, sun.axis_z.w), cascade_slope(c, n));
  return map_occlusion(sun_depths, sun_comparison, c, r, first_tap_direction(noise));
}

#endif
