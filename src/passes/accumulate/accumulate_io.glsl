// What the sum of frames binds.
#ifndef VEL_PASSES_ACCUMULATE_IO_GLSL
#define VEL_PASSES_ACCUMULATE_IO_GLSL

#include "shading/lang.glsl"

SAMPLED(0, 0, texture2D, hdr);
STORAGE(0, 1, rgba32f, image2D, sum);
CONSTANT(bool, kFirst, 0, false);  // the sum begins with this frame

#endif
