// The lobes of one level of smoothness.
#ifndef VEL_BAKE_ENVIRONMENT_PREFILTER_IO_GLSL
#define VEL_BAKE_ENVIRONMENT_PREFILTER_IO_GLSL

#include "shading/lang.glsl"

struct PrefilterPush {
  uint begin, end;  // of the level's samples
};
PUSH(PrefilterPush);
SAMPLED(0, 0, samplerCube, source);
TABLE(0, 1, Samples, vec4 samples[]);  // x, y, level of the source, weight
STORAGE(0, 2, rgba16f, writeonly image2DArray, level);

#endif
