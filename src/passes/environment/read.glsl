// Distant light at a point: irradiance, pre-convolved radiance, reflectance. GLSL only.
#ifndef VEL_PASSES_ENVIRONMENT_READ_GLSL
#define VEL_PASSES_ENVIRONMENT_READ_GLSL

#include "gpu/samplers.glsl"
#include "passes/environment/environment_io.glsl"
#include "shading/brdf.glsl"
#include "shading/environment.glsl"

// World to the environment's own axes.
vec3 to_environment(vec3 d) {
  return turned_to_environment(d, environment.turn.y, environment.turn.z);
}

// Irradiance / pi.
vec3 irradiance_at(vec3 normal_ws) {
  vec3 normal = to_environment(normal_ws);
  if (!kDiffuseSh) return textureLod(samplerCube(environment_irradiance, linear_sampler), normal, 0.0).rgb;
  vec3 coefficients[9];
  for (uint i = 0u; i < 9u; ++i) coefficients[i] = environment.sh[i].rgb;
  return sh_irradiance(coefficients, normal);
}

// The mean radiance of a lobe about a direction.
vec3 lobe_radiance(vec3 direction_ws, float smoothness) {
  vec3 direction = to_environment(direction_ws);
  return textureLod(samplerCube(environment_lobes, linear_sampler), direction, level_of_smoothness(smoothness)).rgb;
}

// E0, E1 of the model in use.
vec2 environment_brdf_at(float n_dot_v, float smoothness) {
  float size = float(textureSize(environment_brdf, 0).x);
  vec2 uv = environment_brdf_uv(n_dot_v, smoothness, size);
  return textureLod(sampler2D(environment_brdf, linear_sampler), uv, 0.0).rg;
}

#endif
