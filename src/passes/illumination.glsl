// Light on a surface: everything that a lit point reads, and the order of light's layers. GLSL only.
//
// Whatever lies between a light and a point belongs into light_shadowed() or light_directional(), and what surrounds the
// point into environment_light(): so every way to find the lights of a pixel sees it.
#ifndef VEL_PASSES_ILLUMINATION_GLSL
#define VEL_PASSES_ILLUMINATION_GLSL

#include "passes/ambient_lights/read.glsl"
#include "passes/area_lights/area_lights_io.glsl"
#include "passes/clip_volumes/read.glsl"
#include "passes/environment/read.glsl"
#include "passes/far_shadows/read.glsl"
#include "passes/illumination_io.glsl"
#include "passes/local_shadows/read.glsl"
#include "passes/projectors/read.glsl"
#include "passes/sun_shadow_mask/sun_shadow_mask_io.glsl"
#include "passes/sun_shadows/read.glsl"
#include "shading/brdf.glsl"
#include "shading/environment.glsl"
#include "shading/area_lights.glsl"
#include "upload/lights_io.glsl"

// What does not depend on the light.
struct ShadingPoint {
  Surface surface;
  vec3 position_ws;
  vec3 face_normal_ws;   // unit, of the surface itself, of either side; only where its light has shadows
  vec3 wo;
  float alpha;
  vec3 specular_scale;
  vec2 env_brdf;
  float sun_visibility;  // of kSunShadowMask
};

ShadingPoint shading_point(Surface surface, vec3 position_ws, vec3 wo) {
  ShadingPoint p;
  p.surface = surface;
  p.position_ws = position_ws;
  p.face_normal_ws = surface.normal_ws;
  p.wo = wo;
  p.alpha = alpha_from_smoothness(surface.smoothness);
  p.env_brdf = environment_brdf_at(clamp(abs(dot(surface.normal_ws, wo)), 0.0, 1.0), surface.smoothness);
  p.specular_scale = kMultiScatter ? energy_compensation(surface.f0, p.env_brdf) : vec3(1.0);
  p.sun_visibility = 1.0;
  return p;
}

// --- what surrounds a point ---------------------------------------------------------------------------------------

vec3 environment_light(ShadingPoint p) {
  if (!kEnvironment) return vec3(0.0);
  Surface s = p.surface;
  vec3 irradiance = irradiance_at(s.normal_ws);
  vec3 radiance = lobe_radiance(reflect(-p.wo, s.normal_ws), s.smoothness);
  vec3 specular = environment_specular(s.f0, f90_from_f0(s.f0), p.env_brdf) * p.specular_scale;
  float n_dot_v = clamp(abs(dot(s.normal_ws, p.wo)), 0.0, 1.0);
  float occlusion = kOcclusion ? s.occlusion : 1.0;
  vec3 diffuse = s.albedo * environment_diffuse_weight(s.f0, specular, kModel) * irradiance * occlusion;
  vec3 light = environment.turn.x * (diffuse + specular * radiance * specular_occlusion(n_dot_v, occlusion, p.alpha));
  // Ambient lights come last, over all that surrounds a point, and have one factor for diffuse and specular light.
  return kAmbientLights ? light * ambient_factor(p.position_ws, s.normal_ws, occlusion) : light;
}

// --- the sun ------------------------------------------------------------------------------------------------------

// Is there a map beyond the cascades?
const bool kBeyondCascades = kFarShadow != kNoFarShadow;

// Whatever normal maps say, what is turned away from the sun by more than this cosine is dark. Nothing nearer to 0, as
// normals that are taken from depths are rough at outlines: the boxes under a sun lose by -0.1, the courtyard gains until -0.03.
const float kFacesAway = -0.15;

// The share of the sun that its maps hide. normal: geometric, unit, of the lit side; noise: in [0, 1).
float sun_occlusion(vec3 position_ws, vec3 normal_ws, float noise) {
  SunPoint p = sun_point(position_ws, normal_ws);
  if (p.normal.z < kFacesAway) return 1.0;
  uint chosen = choose_cascade(p.position, noise, kBeyondCascades);
  if (chosen == sun.cascade_count) return far_occlusion(p, noise);
  return cascade_occlusion(chosen, p, noise);
}

float sun_visibility(ShadingPoint p) {
  if (kSunShadowMask) return p.sun_visibility;
  float noise = screen_noise(pixel_of(p.position_ws), frame.frame_index, frame.seed);
  vec3 lit_side = faceforward(p.face_normal_ws, -sun.axis_z.xyz, p.face_normal_ws);
  return 1.0 - sun_occlusion(p.position_ws, lit_side, noise);
}

// --- lights -------------------------------------------------------------------------------------------------------

// What of a light would go towards the eye if nothing stood in its way.
vec3 light_unshadowed(ShadingPoint p, LightSample light) {
  bool sized = kAreaLights && light.sine > 0.0;
  // The size of a light widens its highlight by half as much, as half vectors turn half as fast.
  float alpha = max(p.alpha, area_lights.min_highlight_alpha - (sized ? 0.5 * light.sine : 0.0));
  vec3 brdf = sized
      ? evaluate_brdf_sphere(p.surface, alpha, p.wo, light.wi, light.sine, p.specular_scale, kModel)
      : evaluate_brdf(p.surface, alpha, p.wo, light.wi, p.specular_scale, kModel);
  // Inside a bulb no direction is that of its light; the path tracer aims at none.
  return light.sine < 1.0 ? brdf * light.irradiance : vec3(0.0);
}

// The same within the light's clip volume.
vec3 light_clipped(ShadingPoint p, GpuLight l, LightSample light) {
  if (!inside_clip_volume(l.clip_volume, p.position_ws, p.surface.normal_ws)) return vec3(0.0);
  return light_unshadowed(p, light);
}

// What the maps of a point or spot light let through. Precondition: has_local_shadow().
vec3 shadow_transmittance(ShadingPoint p, GpuLight l, uint index) {
  float light_radius = l.color.w, noise = 0.0;
  vec3 from_light = p.position_ws - l.position_range.xyz;
  ShadowReceiver r = local_receiver(l, index, from_light);
  if (kLocalShadowTaps > 1u && light_radius > 0.0) {
    r = soft_receiver(r, from_light, p.face_normal_ws, light_radius);
    noise = screen_noise(pixel_of(p.position_ws), frame.frame_index, frame.seed);
  }
  vec3 share = vec3(local_visibility(r, light_radius, noise));
  bool translucent = kLocalTranslucency && share.x > 0.0;
  return translucent ? share * local_transmittance(r, light_radius, noise) : share;
}

// What of a light goes towards the eye past all that its maps hold.
vec3 light_shadowed(ShadingPoint p, GpuLight l, uint index, LightSample light) {
  vec3 radiance = light_clipped(p, l, light);
  bool mapped = has_local_shadow(index) && radiance != vec3(0.0);
  return mapped ? radiance * shadow_transmittance(p, l, index) : radiance;
}

vec3 light_directional(ShadingPoint p, uint index) {
  GpuLight l = lights[index];
  vec3 radiance = light_clipped(p, l, sample_directional(l));
  if (!kSunShadows || index != light_ranges.sun || radiance == vec3(0.0)) return radiance;
  radiance *= sun_visibility(p);
  bool translucent = kSunTranslucency && radiance != vec3(0.0);
  return translucent ? radiance * sun_transmittance(p.position_ws, p.face_normal_ws, kBeyondCascades) : radiance;
}

vec3 light_point(ShadingPoint p, uint index) {
  GpuLight l = lights[index];
  return light_shadowed(p, l, index, sample_point(l, p.position_ws));
}

vec3 light_spot(ShadingPoint p, uint index) {
  GpuLight l = lights[index];
  LightSample light = sample_spot(l, p.position_ws);
  light.irradiance *= projected(l, p.position_ws, light.wi);
  return light_shadowed(p, l, index, light);
}

// Of any kind.
vec3 light_of(ShadingPoint p, uint index) {
  if (index < light_ranges.first_point) return light_directional(p, index);
  return index < light_ranges.first_spot ? light_point(p, index) : light_spot(p, index);
}

#endif
