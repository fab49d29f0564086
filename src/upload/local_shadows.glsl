// What of the light of points and spots arrives past everything that stands between: read in the atlas that
// passes/local_shadows draws. GLSL only; `frame` is the includer's.
#ifndef VEL_UPLOAD_LOCAL_SHADOWS_GLSL
#define VEL_UPLOAD_LOCAL_SHADOWS_GLSL

#include "shading/sampling.glsl"
#include "shading/shadow_atlas.glsl"
#include "shading/shadow_filter.glsl"

layout(set = 1, binding = 5) uniform sampler2D shadow_atlas;                 // nearest
layout(set = 1, binding = 6) uniform sampler2DShadow shadow_atlas_compare;   // bilinear
layout(set = 1, binding = 7, std430) readonly buffer ShadowViewBuffer { ShadowView shadow_views[]; };

layout(constant_id = 7) const uint kLocalShadows = 0u;  // taps of soft shadows; 0: no lamp has a map

// What rounding may leave of a stored depth, as a share of it: large triangles that pass near the light lose digits. 1e-4 is
// enough on lavapipe; SwiftShader, whose vertices snap to 1/16 of a texel, needs four times that.
const float kStoredDepthError = 1e-3;

// Blockers in the fifth of the way that is nearest to the light cast the penumbra of one that stands at its end: to
// look for them would spread all taps over a wide disc.
const float kSearchReach = 4.0;

// A receiver as one view sees it.
struct ShadowReceiver {
  ShadowView view;
  vec2 uv;
  float depth;        // as it is stored in the atlas
  float view_depth;   // along the view's axis, metres
  mat2 uv_from_m;     // how the place in the atlas moves by a metre across the way of light
  float widest_m;     // of filters
};

// 1: what is stored there is no nearer to the light than `depth`.
float lit_share(ShadowReceiver r, vec2 offset_m, float depth) {
  return textureLod(shadow_atlas_compare, vec3(clamp_to_tile(r.view, r.uv + r.uv_from_m * offset_m), depth), 0.0);
}

ShadowReceiver shadow_receiver(ShadowView view, vec3 from_light, float light_radius) {
  ShadowReceiver r;
  r.view = view;
  r.view_depth = shadow_view_depth(view, from_light);
  r.uv = shadow_view_uv(view, from_light, r.view_depth);
  r.depth = view.forward.w / r.view_depth * (1.0 + kStoredDepthError);
  r.uv_from_m = mat2(0.0);
  r.widest_m = 0.0;
  if (light_radius == 0.0) return r;
  float distance = max(length(from_light), view.forward.w);
  vec3 across, along;
  tangent_frame(from_light / distance, across, along);
  vec2 off_axis = r.uv - vec2(view.right.w, view.down.w);
  mat3x2 uv_from_ws = transpose(mat2x3(view.right.xyz - off_axis.x * view.forward.xyz,
                                       view.down.xyz - off_axis.y * view.forward.xyz));
  r.uv_from_m = uv_from_ws * mat2x3(across, along) / r.view_depth;
  // A turn of the direction moves a tangent by 1 / cos^2 of its angle to the axis.
  float in_tile_m = view.tile.y * r.view_depth * r.view_depth / distance;
  r.widest_m = min(in_tile_m, kSearchReach * light_radius);
  return r;
}

// What the search found.
struct LocalBlockers {
  float hiding;  // taps whose blocker stands within the light's cone
  float nearer;  // taps with anything nearer to the light
  float share;   // of the way from the light, that the former stand at: the mean
};

LocalBlockers find_local_blockers(ShadowReceiver r, float light_radius, float noise) {
  LocalBlockers found = LocalBlockers(0.0, 0.0, 0.0);
  float texel_m = r.view.tile.z * r.view_depth;
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < kLocalShadows; ++i) {
    float radius_m = search_tap_radius(i, kLocalShadows, 0.0, r.widest_m);
    vec2 uv = clamp_to_tile(r.view, r.uv + r.uv_from_m * (direction * radius_m));
    float share = r.depth / textureLod(shadow_atlas, uv, 0.0).r;  // infinite where nothing is stored
    if (share < 1.0) found.nearer += 1.0;
    if (share < 1.0 && blocks_light(share * radius_m, (1.0 - share) * light_radius, share * kShadowBorder * texel_m)) {
      found.hiding += 1.0;
      found.share += share;
    }
    direction = next_tap_direction(direction);
  }
  found.share /= max(found.hiding, 1.0);
  return found;
}

float soft_visibility(ShadowReceiver r, float light_radius, float noise) {
  LocalBlockers found = find_local_blockers(r, light_radius, noise);
  if (found.hiding == 0.0) return 1.0;
  if (found.nearer == float(kLocalShadows)) return 0.0;
  float rho = clamp(penumbra_radius_local(1.0, found.share, light_radius) / r.widest_m, 0.0, 1.0);
  uint taps = reduced_tap_count(rho, kLocalShadows);
  float scale = reduced_tap_scale(rho, taps, kLocalShadows);
  float lit = 0.0;
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < taps; ++i) {
    float radius = disc_tap_radius(i, kLocalShadows) * scale;
    float nearer = tap_clearance(min(radius / max(rho, 1e-6), 1.0), 1.0 - found.share);
    lit += lit_share(r, direction * (radius * r.widest_m), r.depth / (1.0 - nearer));
    direction = next_tap_direction(direction);
  }
  return lit / float(taps);
}

// The pixel that a place is seen in.
uvec2 pixel_of(vec3 position_ws) {
  vec4 clip = frame.clip_from_world * vec4(position_ws, 1.0);
  return uvec2(clamp(clip.xy / clip.w * 0.5 + 0.5, 0.0, 1.0) * frame.size.xy);
}

// Side of a texel at a point, metres; 0 where nothing stands in the way. Precondition: l.shadow_view is not 0.
float local_texel(GpuLight l, vec3 position_ws) {
  vec3 from_light = position_ws - l.position_range.xyz;
  uint face = has_one_view(l) ? 0u : shadow_face(from_light);
  ShadowView view = shadow_views[l.shadow_view - 1u + face];
  return view.tile.x == 0.0 ? 0.0 : view.tile.z * shadow_view_depth(view, from_light);
}

// Precondition: l.shadow_view is not 0.
float local_visibility(GpuLight l, vec3 position_ws) {
  vec3 from_light = position_ws - l.position_range.xyz;
  uint face = has_one_view(l) ? 0u : shadow_face(from_light);
  ShadowView view = shadow_views[l.shadow_view - 1u + face];
  if (view.tile.x == 0.0) return 1.0;
  float light_radius = l.color.w;
  ShadowReceiver r = shadow_receiver(view, from_light, light_radius);
  if (r.widest_m == 0.0) return lit_share(r, vec2(0.0), r.depth);
  return soft_visibility(r, light_radius, screen_noise(pixel_of(position_ws), frame.frame_index, frame.seed));
}

#endif
