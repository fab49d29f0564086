#ifndef VEL_SHADING_LIGHTS_GLSL
#define VEL_SHADING_LIGHTS_GLSL

#include "shading/attenuation.glsl"
#include "shading/lang.glsl"

// GpuLight::direction.w
const float kLightDirectional = 0.0f;
const float kLightPoint = 1.0f;
const float kLightSpot = 2.0f;

// GpuLight::cone.w
const float kFalloffInverseSquare = 0.0f;  // KHR_lights_punctual
const float kFalloffBulb = 1.0f;           // [Schulz 2014]

const uint kLightCastsShadow = 1u;  // GpuLight::flags

// The radius of a light without an end: beyond every scene, yet its square is finite in fp32.
const float kUnboundedRadius = 1e18f;

// A light: KHR_lights_punctual, and what the scene's extras add.
struct GpuLight {
  vec4 position_range;  // xyz: world space, metres; w: range in metres, 0 without end
  vec4 direction;       // xyz: unit, where the light shines to (directional, spot); w: kLightDirectional, ...
  vec4 color;           // rgb: colour times intensity, lux (directional) or candela; w: radius of the bulb in metres (point, spot), sine of the disc's angular radius (directional); 0: no size
  vec4 cone;            // spot: xy: spot_scale_offset(), z: cosine of the outer angle; w: kFalloffInverseSquare, ...
  vec4 projector;       // xyz: unit, where +u of the projected picture goes, at right angles to direction; w: tangent of half its field of view
  uint projector_layer; // 1 + the layer of the projected picture, 0: none
  uint clip_volume;     // 1 + the volume that the light ends at, 0: none
  uint flags;           // kLightCastsShadow
  uint unused;
};
CHECK_LAYOUT(GpuLight, position_range, 0);
CHECK_LAYOUT(GpuLight, direction, 16);
CHECK_LAYOUT(GpuLight, color, 32);
CHECK_LAYOUT(GpuLight, cone, 48);
CHECK_LAYOUT(GpuLight, projector, 64);
CHECK_LAYOUT(GpuLight, projector_layer, 80);

struct LightSample {
  vec3 wi;          // unit, from the point towards the light
  vec3 irradiance;  // lux on a plane that faces the light
  float sine;       // of the half angle under which the light is seen; 0: a point, 1: from inside the bulb
};

FN bool is_directional(IN(GpuLight) l) {
  return l.direction.w < 0.5f * kLightPoint;
}

FN bool is_spot(IN(GpuLight) l) {
  return l.direction.w > 0.5f * (kLightPoint + kLightSpot);
}

// The light that arrives at `position` (world space), shadows aside, from a light of each kind.
// Shaders loop over one kind after the other, so that no light pays for what another kind needs.
FN LightSample sample_directional(IN(GpuLight) l) {
  LightSample result;
  result.wi = -vec3(l.direction.x, l.direction.y, l.direction.z);
  result.irradiance = vec3(l.color.x, l.color.y, l.color.z);
  result.sine = l.color.w;
  return result;
}

FN float punctual_attenuation(IN(GpuLight) l, float distance) {
  if (l.cone.w > 0.5f * kFalloffBulb) return bulb_attenuation(distance, l.color.w, l.position_range.w);
  return range_attenuation(distance, l.position_range.w);
}

FN LightSample sample_point(IN(GpuLight) l, vec3 position) {
  vec3 to_light = vec3(l.position_range.x, l.position_range.y, l.position_range.z) - position;
  float distance = length(to_light);
  LightSample result;
  // At the light itself every direction is as good.
  result.wi = distance > 0.0f ? to_light / distance : vec3(0.0f, 1.0f, 0.0f);
  result.irradiance = vec3(l.color.x, l.color.y, l.color.z) * punctual_attenuation(l, distance);
  result.sine = min(l.color.w / max(distance, kMinLightDistance), 1.0f);
  return result;
}

FN LightSample sample_spot(IN(GpuLight) l, vec3 position) {
  LightSample result = sample_point(l, position);
  float cosine = -dot(vec3(l.direction.x, l.direction.y, l.direction.z), result.wi);
  result.irradiance *= spot_attenuation(cosine, vec2(l.cone.x, l.cone.y));
  return result;
}

// Of any kind.
FN LightSample sample_light(IN(GpuLight) l, vec3 position) {
  if (is_directional(l)) return sample_directional(l);
  if (is_spot(l)) return sample_spot(l, position);
  return sample_point(l, position);
}

// The distance at and beyond which the light gives exactly nothing; kUnboundedRadius where there is none.
FN float light_cull_radius(IN(GpuLight) l) {
  return is_directional(l) || l.position_range.w == 0.0f ? kUnboundedRadius : l.position_range.w;
}

#endif
