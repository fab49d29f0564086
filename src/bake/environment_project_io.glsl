// An equirectangular picture and the cube made of it.
#ifndef VEL_BAKE_ENVIRONMENT_PROJECT_IO_GLSL
#define VEL_BAKE_ENVIRONMENT_PROJECT_IO_GLSL

#include "shading/lang.glsl"

struct ProjectPush {
  uint taps, mip;
};
PUSH(ProjectPush);
SAMPLED(0, 0, sampler2D, equirect);
STORAGE(0, 1, rgba16f, writeonly image2DArray, cube);
STORAGE(0, 2, rgba16f, writeonly image2DArray, mirror);

#endif
