// How light falls off with distance and angle. Distances in metres.
#ifndef VEL_SHADING_ATTENUATION_GLSL
#define VEL_SHADING_ATTENUATION_GLSL

#include "shading/lang.glsl"

// Nearer than this a punctual light is as bright as here: real lights are no points, and the result must stay finite.
const float kMinLightDistance = 1e-3f;

// 1 / d^2 with the window that KHR_lights_punctual recommends: 0 at `range` and beyond. range 0: no end. Per m^2.
FN float range_attenuation(float distance, float range) {
  require(distance >= 0.0f && range >= 0.0f);
  float d = max(distance, kMinLightDistance);
  float ratio = range > 0.0f ? distance / range : 0.0f;
  float ratio2 = ratio * ratio;
  return clamp(1.0f - ratio2 * ratio2, 0.0f, 1.0f) / (d * d);
}

// What the cosines of a hard cone's two angles differ by: sixteen steps of a float below 1, so that the edge is an edge and
// narrow cones are as bright on their axis as wide ones. The extension's sample code has 0.001, which is all that a cone of
// 2.6 degrees has.
const float kLeastConeDifference = 1e-6f;

// Scale and offset for spot_attenuation [KHR_lights_punctual]; angles from the axis, radians, inner <= outer.
FN vec2 spot_scale_offset(float inner, float outer) {
  float cos_outer = cos(outer);
  float scale = 1.0f / max(kLeastConeDifference, cos(inner) - cos_outer);
  return vec2(scale, -cos_outer * scale);
}

// 1 inside the inner cone, 0 outside the outer one. cos_angle: between the axis and the way from light to point.
FN float spot_attenuation(float cos_angle, vec2 scale_offset) {
  float t = clamp(cos_angle * scale_offset.x + scale_offset.y, 0.0f, 1.0f);
  return t * t;
}

// Falloff of a uniform spherical bulb, 1 at one metre from its surface [Schulz 2014]: ((1 + b) / (d + b))^2 with
// d measured from the surface. This is the exact irradiance of a sphere that faces the receiver.
FN float bulb_falloff(float center_distance, float bulb_radius) {
  require(bulb_radius > 0.0f);
  float ratio = (1.0f + bulb_radius) / max(center_distance, bulb_radius);
  return ratio * ratio;
}

// 1 until 0.8 of the cutoff radius, then linearly to 0 at the radius. cutoff_radius 0: no end.
FN float cutoff_fade(float center_distance, float cutoff_radius) {
  require(cutoff_radius >= 0.0f);
  if (cutoff_radius == 0.0f) return 1.0f;
  return clamp((cutoff_radius - center_distance) / (0.2f * cutoff_radius), 0.0f, 1.0f);
}

// Ryse's attenuation: the bulb, ended at the cutoff radius by the squared fade, whose slope is 0 there.
FN float bulb_attenuation(float center_distance, float bulb_radius, float cutoff_radius) {
  float fade = cutoff_fade(center_distance, cutoff_radius);
  return bulb_falloff(center_distance, bulb_radius) * fade * fade;
}

#endif
