// Distant light, as lit points and the background read it.
#ifndef VEL_PASSES_ENVIRONMENT_ENVIRONMENT_IO_GLSL
#define VEL_PASSES_ENVIRONMENT_ENVIRONMENT_IO_GLSL

#include "shading/lang.glsl"

struct Environment {
  vec4 background;  // rgb linear, premultiplied by the coverage a; where the environment is not shown
  vec4 turn;        // x: intensity, y z: cosine and sine of its rotation about +Y, w: 1 where it is the background
  vec4 sh[9];       // rgb: coefficients of its radiance (intensity left out)
};
CHECK_LAYOUT(Environment, sh, 32);

SAMPLED(1, 0, textureCube, environment_lobes);       // pre-convolved levels
SAMPLED(1, 1, texture2D, environment_brdf);          // E0, E1 by (n.v, smoothness)
SAMPLED(1, 4, textureCube, environment_irradiance);  // irradiance / pi
TABLE(1, 18, EnvironmentBuffer, Environment environment);
CONSTANT(bool, kEnvironment, 4, true);               // there is one
CONSTANT(bool, kDiffuseSh, 5, false);                // irradiance from environment.sh, else from environment_irradiance
CONSTANT(bool, kOcclusion, 3, true);                 // baked occlusion darkens it

#endif
