// What BLEND surfaces leave of the light of points and spots: read beside the atlas of depth, by the same views and with the
// same kernels (upload/local_shadows.glsl). GLSL only; `frame` is the includer's.
#ifndef VEL_UPLOAD_LOCAL_VEILS_GLSL
#define VEL_UPLOAD_LOCAL_VEILS_GLSL

#include "upload/local_shadows.glsl"
#include "upload/veils.glsl"

layout(set = 1, binding = 14) uniform sampler2DArray shadow_atlas_veils;  // nearest; one layer

// Half as many as opaque casters get, as contrasts are lower: FLIP of penumbrae of dye grows by a fiftieth.
const uint kLocalVeilTaps = kLocalShadows / 2u;

vec4 local_veil(ShadowReceiver r, vec2 offset_m) {
  return textureLod(shadow_atlas_veils, vec3(clamp_to_tile(r.view, r.uv + r.uv_from_m * offset_m), 0.0), 0.0);
}

// Of the veils within the light's cone, means: rgb what passes them; a the share of the way from the light that they stand
// at, 1 where there is none.
vec4 find_local_veils(ShadowReceiver r, float light_radius, float noise) {
  float found = 0.0;
  vec4 sum = vec4(0.0);
  float texel_m = r.view.tile.z * r.view_depth;
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < kLocalVeilTaps; ++i) {
    float radius_m = wide_search_tap_radius(i, kLocalVeilTaps, r.usual_m, r.widest_m);
    vec2 offset_m = direction * radius_m;
    vec4 veil = local_veil(r, offset_m);
    float depth = receiver_depth(r, offset_m), share = veil.a > depth ? r.depth / veil.a : 1.0;
    if (share < 1.0 && blocks_light(share * radius_m, (1.0 - share) * light_radius, share * kShadowBorder * texel_m)) {
      found += 1.0;
      sum += vec4(past_veil(veil, depth), share);
    }
    direction = next_tap_direction(direction);
  }
  return found > 0.0 ? sum / found : vec4(1.0);
}

vec3 soft_local_transmittance(ShadowReceiver r, float light_radius, float noise) {
  vec4 found = find_local_veils(r, light_radius, noise);
  if (found.a == 1.0) return vec3(1.0);
  float rho = penumbra_ratio_local(r, light_radius, found.a);
  uint taps = reduced_tap_count(min(rho, 1.0), kLocalVeilTaps);
  float scale = reduced_tap_scale(rho, taps, kLocalVeilTaps) * r.usual_m;
  vec4 sum = kUnseenVeilWeight * vec4(found.rgb, 1.0);
  vec2 direction = first_tap_direction(noise);
  for (uint i = 0u; i < taps; ++i) {
    vec2 offset_m = direction * (disc_tap_radius(i, kLocalVeilTaps) * scale);
    float seen = lit_share(r, offset_m, r.depth / found.a);
    sum += seen * vec4(past_veil(local_veil(r, offset_m), receiver_depth(r, offset_m)), 1.0);
    direction = next_tap_direction(direction);
  }
  return sum.rgb / sum.a;
}

// r: as local_visibility()'s.
vec3 local_transmittance(ShadowReceiver r, float light_radius, float noise) {
  bool veiled = may_be_veiled(r.view, r.view_depth, r.uv), sharp = light_radius == 0.0;
  vec3 place = vec3(clamp_to_tile(r.view, r.uv), 0.0);
  vec3 passing = bilinear_veil(shadow_atlas_veils, place, r.depth, veiled && sharp);
  return veiled && !sharp ? soft_local_transmittance(r, light_radius, noise) : passing;
}

#endif
