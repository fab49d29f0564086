// Lights that multiply what surrounds a point, on the device. GLSL only.
#ifndef VEL_PASSES_AMBIENT_LIGHTS_READ_GLSL
#define VEL_PASSES_AMBIENT_LIGHTS_READ_GLSL

#include "passes/ambient_lights/ambient_lights_io.glsl"
#include "shading/ambient_light.glsl"
#include "shading/constants.glsl"

// What all ambient lights together multiply diffuse and specular light by; a number whatever their colours are.
// The loop has one way out, at its end, and asks every light: drivers that run pixels in lockstep gain nothing from others.
vec3 ambient_factor(vec3 position_ws, vec3 normal_ws, float occlusion) {
  vec3 factor = vec3(1.0);
  for (uint i = 0u; i < ambient.count; ++i)
    factor = min(factor * ambient_light_factor(ambient_lights[i], position_ws, normal_ws, occlusion), kLargestHalf);
  return factor;
}

#endif
