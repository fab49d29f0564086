// A mip of an environment cube and the next one.
#ifndef VEL_BAKE_ENVIRONMENT_MIP_IO_GLSL
#define VEL_BAKE_ENVIRONMENT_MIP_IO_GLSL

#include "shading/lang.glsl"

STORAGE(0, 0, rgba16f, readonly image2DArray, larger);
STORAGE(0, 1, rgba16f, writeonly image2DArray, smaller);

#endif
