// What of the light of points and spots arrives past everything that stands between: read in the shadow atlas. GLSL only.
#ifndef VEL_PASSES_LOCAL_SHADOWS_READ_GLSL
#define VEL_PASSES_LOCAL_SHADOWS_READ_GLSL

#include "gpu/samplers.glsl"
#include "passes/local_shadows/local_shadows_io.glsl"
#include "passes/translucency_map.glsl"
#include "shading/sampling.glsl"
#include "shading/shadow_atlas.glsl"
#include "shading/shadow_filter.glsl"
#include "upload/frame.glsl"

// What rounding may leave of a stored depth, as a share of it: large triangles that pass near the light lose digits. 1e-4 is
// enough on lavapipe; SwiftShader, whose vertices snap to 1/16 of a texel, needs four times that.
const float kStoredDepthError = 1e-3;

// Blockers in the fifth of the way that is nearest to the light cast penumbrae wider than this, in radii of the light; few
// taps look for them.
const float kUsualPenumbra = 4.0;

// A receiver as one view sees it.
struct ShadowReceiver {
  ShadowView view;
  vec2 uv;
  float depth;        // as it is stored in the atlas
  float view_depth;   // along the view's axis, metres
  mat2 uv_from_m;     // how the place in the atlas moves by a metre across the way of light
  float usual_m;      // radii of filters, metres: beyond this one few taps look for blockers,
  float widest_m;     // beyond this one none
  vec2 slope;         // how the depth of the receiver's own plane rises towards the light, by a metre across the way of light
};

// 1: what is stored there is no nearer to the light than `depth`.
float pcf_tap(ShadowReceiver r, vec2 offset_m, float depth) {
  vec2 uv = clamp_to_tile(r.view, r.uv + r.uv_from_m * offset_m);
  return textureLod(sampler2DShadow(shadow_atlas, compare_sampler), vec3(uv, depth), 0.0);
}

// What a tap compares with: the receiver, and its own plane where that is nearer to the light.
float receiver_depth(ShadowReceiver r, vec2 offset_m) {
  return r.depth + max(dot(r.slope, offset_m), 0.0);
}

ShadowReceiver shadow_receiver(ShadowView view, vec3 from_light) {
  ShadowReceiver r;
  r.view = view;
  r.view_depth = shadow_view_depth(view, from_light);
  r.uv = shadow_view_uv(view, from_light, r.view_depth);
  r.depth = view.forward.w / r.view_depth * (1.0 + kStoredDepthError);
  r.uv_from_m = mat2(0.0);
  r.usual_m = 0.0;
  r.widest_m = 0.0;
  r.slope = vec2(0.0);
  return r;
}

// Planes that light grazes at less than this sine rise without end.
const float kLeastGrazing = 0.02;

// What filters need besides. face_normal: of the receiver's plane, unit, of either side.
ShadowReceiver soft_receiver(ShadowReceiver hard, vec3 from_light, vec3 face_normal, float light_radius) {
  ShadowReceiver r = hard;
  ShadowView view = r.view;
  float distance = max(length(from_light), view.forward.w);
  vec3 across, along;
  tangent_frame(from_light / distance, across, along);
  vec2 off_axis = r.uv - vec2(view.right.w, view.down.w);
  mat3x2 uv_from_ws = transpose(mat2x3(view.right.xyz - off_axis.x * view.forward.xyz,
                                       view.down.xyz - off_axis.y * view.forward.xyz));
  r.uv_from_m = uv_from_ws * mat2x3(across, along) / r.view_depth;
  // A turn of the direction moves a tangent by 1 / cos^2 of its angle to the axis.
  r.widest_m = view.tile.y * r.view_depth * r.view_depth / distance;
  r.usual_m = min(r.widest_m, kUsualPenumbra * light_radius);
  // Stored depth is linear in tangents on every plane.
  float towards = dot(face_normal, from_light);
  float grazing = max(abs(towards), kLeastGrazing * distance) * (towards < 0.0 ? -1.0 : 1.0);
  vec2 rise = vec2(dot(face_normal, view.right.xyz), dot(face_normal, view.down.xyz));
  r.slope = r.depth * r.view_depth / (grazing * dot(view.right.xyz, view.right.xyz)) * (rise * r.uv_from_m);
  return r;
}

// What the search found. Shares are of the way from the light.
struct LocalBlockers {
  float hiding;    // taps whose blocker stands within the light's cone, or beside it where none stands within
  float nearer;    // taps with anything nearer to the light
  float share;     // that the former stand at: the mean
  float nearest;   // of those within the cone, to the light
  float farthest;
};

// Where what tap i of the search sees stands; 1: it is no blocker.
float blocker_share(ShadowReceiver r, uint i, vec2 direction) {
  vec2 offset_m = direction * wide_search_tap_radius(i, kLocalShadowTaps, r.usual_m, r.widest_m);
  float stored = textureLod(sampler2D(shadow_atlas, nearest_sampler), clamp_to_tile(r.view, r.uv + r.uv_from_m * offset_m), 0.0).r;
  return stored > receiver_depth(r, offset_m) ? r.depth / stored : 1.0;
}

// Does a blocker that tap i has found stand within the light's cone, `width` times as wide?
bool stands_in_cone(ShadowReceiver r, float light_radius, uint i, float share, float width) {
  float radius_m = wide_search_tap_radius(i, kLocalShadowTaps, r.usual_m, r.widest_m);
  float texel_m = r.view.tile.z * r.view_depth;
  return blocks_light(share * radius_m, width * (1.0 - share) * light_radius, share * kShadowBorder * texel_m);
}

LocalBlockers find_local_blockers(ShadowReceiver r, float light_radius, float noise) {
  LocalBlockers found = LocalBlockers(0.0, 0.0, 0.0, 1.0, 1.0);
  vec2 within = vec2(0.0), beside = vec2(0.0);  // count and sum of shares
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < kLocalShadowTaps; ++i) {
    float share = blocker_share(r, i, direction);
    if (share < 1.0) found.nearer += 1.0;
    if (share < 1.0 && stands_in_cone(r, light_radius, i, share, kConeWidth)) beside += vec2(1.0, share);
    if (share < 1.0 && stands_in_cone(r, light_radius, i, share, 1.0)) {
      found.farthest = within.x == 0.0 ? share : max(found.farthest, share);
      found.nearest = min(found.nearest, share);
      within += vec2(1.0, share);
    }
    direction = next_tap_direction(direction);
  }
  vec2 chosen = within.x > 0.0 ? within : beside;
  found.hiding = chosen.x;
  found.share = chosen.y / max(chosen.x, 1.0);
  return found;
}

// Of blockers before (x) and beyond (y) the depth at `split`, the mean shares; those of one layer are all before it.
struct LocalLayers {
  float split;   // share of the way from the light; 0: there is one layer
  vec2 shares;
};

LocalLayers layers_of(ShadowReceiver r, LocalBlockers found, float light_radius, float noise) {
  // Penumbrae are as wide as 1 / share - 1.
  float near_width = 1.0 / found.farthest - 1.0, far_width = 1.0 / found.nearest - 1.0;
  LocalLayers layers = LocalLayers(0.0, vec2(found.share));
  if (are_layered(near_width, far_width)) {
    layers.split = 1.0 / (1.0 + layer_split(near_width, far_width));
    vec2 sum = vec2(0.0), count = vec2(0.0);
    vec2 direction = first_tap_direction(noise);
    for (uint i = 0u; i < kLocalShadowTaps; ++i) {
      float share = blocker_share(r, i, direction);
      bool counts = share < 1.0 && stands_in_cone(r, light_radius, i, share, 1.0);
      vec2 side = vec2(counts && share >= layers.split, counts && share < layers.split);
      sum += side * share;
      count += side;
      direction = next_tap_direction(direction);
    }
    layers.shares = sum / max(count, vec2(1.0));
  }
  return layers;
}

// Of blockers at this share of the way, as a share of the usual one; up to that of the widest.
float penumbra_ratio_local(ShadowReceiver r, float light_radius, float share) {
  return min(penumbra_radius_local(1.0, share, light_radius), r.widest_m) / r.usual_m;
}

float layered_visibility(ShadowReceiver r, LocalLayers layers, float light_radius, float noise) {
  float far_rho = penumbra_ratio_local(r, light_radius, layers.shares.y);
  float near_rho = penumbra_ratio_local(r, light_radius, layers.shares.x);
  float far_depth = r.depth / max(layers.split, 1e-6);
  uint taps = reduced_tap_count(min(far_rho, 1.0), kLocalShadowTaps);
  float scale = reduced_tap_scale(1.0, taps, kLocalShadowTaps) * r.usual_m;
  LayeredRays rays = no_rays();
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < taps; ++i) {
    vec2 ray = direction * (disc_tap_radius(i, kLocalShadowTaps) * scale), near_m = near_rho * ray;
    float past_near = pcf_tap(r, near_m, receiver_depth(r, near_m)), past_far = 1.0, near_seen = 1.0;
    if (layers.split > 0.0) {
      past_far = pcf_tap(r, far_rho * ray, far_depth);
      near_seen = pcf_tap(r, near_m, far_depth);
    }
    rays = with_ray(rays, past_far, near_seen, past_near);
    direction = next_tap_direction(direction);
  }
  return visibility_of(rays, taps);
}

float soft_visibility(ShadowReceiver r, float light_radius, float noise) {
  LocalBlockers found = find_local_blockers(r, light_radius, noise);
  float visibility = found.hiding == 0.0 ? 1.0 : 0.0;
  if (found.hiding > 0.0 && found.nearer < float(kLocalShadowTaps))
    visibility = layered_visibility(r, layers_of(r, found, light_radius, noise), light_radius, noise);
  return visibility;
}

// Has the light a map?
bool has_local_shadow(uint index) {
  return kLocalShadowTaps != 0u && first_shadow_view[index] != 0u;
}

// A place as the view of a light sees it that looks there. Precondition: has_local_shadow().
ShadowReceiver local_receiver(GpuLight l, uint index, vec3 from_light) {
  uint face = has_one_view(l) ? 0u : shadow_face(from_light);
  return shadow_receiver(shadow_views[first_shadow_view[index] - 1u + face], from_light);
}

// Side of a texel at a point, metres; 0 where nothing stands in the way. Precondition: has_local_shadow().
float local_texel(GpuLight l, uint index, vec3 position_ws) {
  ShadowReceiver r = local_receiver(l, index, position_ws - l.position_range.xyz);
  return r.view.tile.x == 0.0 ? 0.0 : r.view.tile.z * r.view_depth;
}

// r: local_receiver(), of a light that has a size soft_receiver().
float local_visibility(ShadowReceiver r, float light_radius, float noise) {
  float visibility = 1.0;
  if (r.view.tile.x > 0.0 && light_radius == 0.0) visibility = pcf_tap(r, vec2(0.0), r.depth);
  if (kLocalShadowTaps > 1u && r.view.tile.x > 0.0 && light_radius > 0.0)
    visibility = soft_visibility(r, light_radius, noise);
  return visibility;
}

// Half as many as opaque casters get, as contrasts are lower: FLIP of penumbrae of dye grows by a fiftieth.
const uint kLocalTranslucencyTaps = kLocalShadowTaps / 2u;

vec4 local_translucency_at(ShadowReceiver r, vec2 offset_m) {
  vec2 uv = clamp_to_tile(r.view, r.uv + r.uv_from_m * offset_m);
  return textureLod(sampler2DArray(local_translucency, nearest_sampler), vec3(uv, 0.0), 0.0);
}

// Means over the BLEND surfaces within the light's cone: rgb what passes them; a the share of the way from the light that
// they stand at, 1 where there is none.
vec4 find_local_translucency(ShadowReceiver r, float light_radius, float noise) {
  float found = 0.0;
  vec4 sum = vec4(0.0);
  float texel_m = r.view.tile.z * r.view_depth;
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < kLocalTranslucencyTaps; ++i) {
    float radius_m = wide_search_tap_radius(i, kLocalTranslucencyTaps, r.usual_m, r.widest_m);
    vec2 offset_m = direction * radius_m;
    vec4 texel = local_translucency_at(r, offset_m);
    float depth = receiver_depth(r, offset_m), share = texel.a > depth ? r.depth / texel.a : 1.0;
    if (share < 1.0 && blocks_light(share * radius_m, (1.0 - share) * light_radius, share * kShadowBorder * texel_m)) {
      found += 1.0;
      sum += vec4(map_transmittance(texel, depth), share);
    }
    direction = next_tap_direction(direction);
  }
  return found > 0.0 ? sum / found : vec4(1.0);
}

vec3 soft_local_transmittance(ShadowReceiver r, float light_radius, float noise) {
  vec4 found = find_local_translucency(r, light_radius, noise);
  if (found.a == 1.0) return vec3(1.0);
  float rho = penumbra_ratio_local(r, light_radius, found.a);
  uint taps = reduced_tap_count(min(rho, 1.0), kLocalTranslucencyTaps);
  float scale = reduced_tap_scale(rho, taps, kLocalTranslucencyTaps) * r.usual_m;
  vec4 sum = kUnseenTranslucencyWeight * vec4(found.rgb, 1.0);
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < taps; ++i) {
    vec2 offset_m = direction * (disc_tap_radius(i, kLocalTranslucencyTaps) * scale);
    float seen = pcf_tap(r, offset_m, r.depth / found.a);
    sum += seen * vec4(map_transmittance(local_translucency_at(r, offset_m), receiver_depth(r, offset_m)), 1.0);
    direction = next_tap_direction(direction);
  }
  return sum.rgb / sum.a;
}

// r: as local_visibility()'s.
vec3 local_transmittance(ShadowReceiver r, float light_radius, float noise) {
  bool behind = may_be_translucent(r.view, r.view_depth, r.uv), sharp = light_radius == 0.0;
  vec3 place = vec3(clamp_to_tile(r.view, r.uv), 0.0);
  vec3 passing = bilinear_transmittance(local_translucency, place, r.depth, behind && sharp);
  return behind && !sharp ? soft_local_transmittance(r, light_radius, noise) : passing;
}

#endif
