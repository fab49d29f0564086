// Light on a surface: what all passes that shade share. GLSL only.
// The includer defines, before: FrameUniforms frame; the textures and the light table below are bound in set 1, by
// passes/shading_inputs.
#ifndef VEL_UPLOAD_FRAME_LIGHTING_GLSL
#define VEL_UPLOAD_FRAME_LIGHTING_GLSL

#include "shading/brdf.glsl"
#include "shading/environment.glsl"
#include "shading/sphere_light.glsl"
#include "upload/clip_volumes.glsl"
#include "upload/gpu_structs.glsl"
#include "upload/local_shadows.glsl"
#include "upload/local_veils.glsl"
#include "upload/projectors.glsl"
#include "upload/sun_veils.glsl"

layout(set = 1, binding = 0) uniform samplerCube environment_map;      // pre-convolved levels
layout(set = 1, binding = 1) uniform sampler2D environment_brdf_table; // E0, E1 by (n.v, smoothness)
layout(set = 1, binding = 2, std430) readonly buffer LightBuffer { GpuLight lights[]; };
layout(set = 1, binding = 4) uniform samplerCube irradiance_map;       // irradiance / pi

layout(constant_id = 1) const uint kModel = 0u;            // kModelGltf, kModelRyse
layout(constant_id = 2) const uint kMultiScatter = 1u;
layout(constant_id = 3) const uint kOcclusion = 1u;
layout(constant_id = 4) const uint kEnvironment = 1u;      // 0: there is none
layout(constant_id = 5) const uint kDiffuseSh = 0u;        // 1: irradiance from frame.sh, 0: from irradiance_map
layout(constant_id = 6) const uint kSunShadows = 0u;       // 1: frame.sun_light casts shadows

layout(constant_id = 11) const uint kSphereHighlights = 0u; // 0: no light has a size
layout(constant_id = 14) const float kMinHighlightAlpha = 0.002325;

// What does not depend on the light.
struct ShadingPoint {
  Surface surface;
  vec3 position_ws;
  vec3 face_normal_ws;   // unit, of the surface itself, of either side; only where its light has shadows
  vec3 wo;
  float alpha;
  vec3 specular_scale;
  vec2 env_brdf;
};

ShadingPoint shading_point(Surface surface, vec3 position_ws, vec3 wo) {
  ShadingPoint p;
  p.surface = surface;
  p.position_ws = position_ws;
  p.face_normal_ws = surface.normal_ws;
  p.wo = wo;
  p.alpha = alpha_from_smoothness(surface.smoothness);
  float n_dot_v = clamp(abs(dot(surface.normal_ws, wo)), 0.0, 1.0);
  float size = float(textureSize(environment_brdf_table, 0).x);
  p.env_brdf = textureLod(environment_brdf_table, environment_brdf_uv(n_dot_v, surface.smoothness, size), 0.0).rg;
  p.specular_scale = kMultiScatter != 0u ? energy_compensation(surface.f0, p.env_brdf) : vec3(1.0);
  return p;
}

// World to the environment's own axes: the inverse of its turn about +Y, which takes +Z to +X.
vec3 to_environment(vec3 d, FrameUniforms frame) {
  float c = frame.environment.y, s = frame.environment.z;
  return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

// What occlusion leaves of the mirror direction [Lagarde & de Rousiers 2014, "Moving Frostbite to PBR", listing 26].
float specular_occlusion(float n_dot_v, float occlusion, float alpha) {
  return clamp(pow(n_dot_v + occlusion, exp2(-16.0 * alpha - 1.0)) - 1.0 + occlusion, 0.0, 1.0);
}

// Irradiance / pi. normal: in the environment's own axes.
vec3 environment_irradiance(vec3 normal, FrameUniforms frame) {
  if (kDiffuseSh == 0u) return textureLod(irradiance_map, normal, 0.0).rgb;
  vec3 coefficients[9];
  for (uint i = 0u; i < 9u; ++i) coefficients[i] = frame.sh[i].rgb;
  return sh_irradiance(coefficients, normal);
}

vec3 environment_light(ShadingPoint p, FrameUniforms frame) {
  if (kEnvironment == 0u) return vec3(0.0);
  Surface s = p.surface;
  vec3 irradiance = environment_irradiance(to_environment(s.normal_ws, frame), frame);
  vec3 mirrored = to_environment(reflect(-p.wo, s.normal_ws), frame);
  vec3 radiance = textureLod(environment_map, mirrored, level_of_smoothness(s.smoothness)).rgb;
  vec3 specular = environment_specular(s.f0, f90_from_f0(s.f0), p.env_brdf) * p.specular_scale;
  float n_dot_v = clamp(abs(dot(s.normal_ws, p.wo)), 0.0, 1.0);
  float occlusion = kOcclusion != 0u ? s.occlusion : 1.0;
  vec3 diffuse = s.albedo * environment_diffuse_weight(s.f0, specular, kModel) * irradiance * occlusion;
  return frame.environment.x * (diffuse + specular * radiance * specular_occlusion(n_dot_v, occlusion, p.alpha));
}

// The share of the sun, frame.sun_light, that reaches the point past what is far and near. The includer defines it.
float sun_visibility(ShadingPoint p);

// What of a lamp's light would go towards the eye if nothing stood in its way.
vec3 reflected_openly(ShadingPoint p, LightSample light) {
  bool sized = kSphereHighlights != 0u && light.sine > 0.0;
  // The size of a light widens its highlight by half as much, as half vectors turn half as fast.
  float alpha = max(p.alpha, kMinHighlightAlpha - (sized ? 0.5 * light.sine : 0.0));
  vec3 brdf = sized
      ? evaluate_brdf_sphere(p.surface, alpha, p.wo, light.wi, light.sine, p.specular_scale, kModel)
      : evaluate_brdf(p.surface, alpha, p.wo, light.wi, p.specular_scale, kModel);
  // Inside a bulb no direction is that of its light; the path tracer aims at none.
  return light.sine < 1.0 ? brdf * light.irradiance : vec3(0.0);
}

// The same within the light's clip volume.
vec3 reflected_inside(ShadingPoint p, GpuLight l, LightSample light) {
  if (!inside_clip_volume(l.clip_volume, p.position_ws, p.surface.normal_ws)) return vec3(0.0);
  return reflected_openly(p, light);
}

// What the maps of a lamp let through. Precondition: l.shadow_view is not 0.
vec3 let_through(ShadingPoint p, GpuLight l) {
  float light_radius = l.color.w, noise = 0.0;
  vec3 from_light = p.position_ws - l.position_range.xyz;
  ShadowReceiver r = local_receiver(l, from_light);
  if (kLocalShadows > 1u && light_radius > 0.0) {
    r = soft_receiver(r, from_light, p.face_normal_ws, light_radius);
    noise = screen_noise(pixel_of(p.position_ws), frame.frame_index, frame.seed);
  }
  vec3 share = vec3(local_visibility(r, light_radius, noise));
  bool veils = (kTranslucentShadows & kLocalVeils) != 0u && share.x > 0.0;
  return veils ? share * local_transmittance(r, light_radius, noise) : share;
}

// What of a lamp's light goes towards the eye past all that its maps hold.
vec3 reflected(ShadingPoint p, GpuLight l, LightSample light) {
  vec3 radiance = reflected_inside(p, l, light);
  bool mapped = kLocalShadows != 0u && l.shadow_view != 0u && radiance != vec3(0.0);
  return mapped ? radiance * let_through(p, l) : radiance;
}

// What a lamp of each kind adds: whatever lies between a lamp and a point belongs into these, or into reflected(), so that
// every way to find the lamps of a pixel sees it.
vec3 light_directional(ShadingPoint p, uint index) {
  GpuLight l = lights[index];
  LightSample light = sample_directional(l);
  if (kSunShadows == 0u || index != frame.sun_light) return reflected(p, l, light);
  vec3 radiance = reflected_inside(p, l, light);
  if (radiance == vec3(0.0)) return radiance;
  radiance *= sun_visibility(p);
  bool veiled = (kTranslucentShadows & kSunVeils) != 0u && radiance != vec3(0.0);
  return veiled ? radiance * sun_transmittance(p.position_ws, p.face_normal_ws) : radiance;
}

vec3 light_point(ShadingPoint p, uint index) {
  GpuLight l = lights[index];
  return reflected(p, l, sample_point(l, p.position_ws));
}

vec3 light_spot(ShadingPoint p, uint index) {
  GpuLight l = lights[index];
  LightSample light = sample_spot(l, p.position_ws);
  light.irradiance *= projected(l, p.position_ws, light.wi);
  return reflected(p, l, light);
}

// Of any kind.
vec3 light_of(ShadingPoint p, uint index, FrameUniforms frame) {
  if (index < frame.first_point) return light_directional(p, index);
  return index < frame.first_spot ? light_point(p, index) : light_spot(p, index);
}

#endif
