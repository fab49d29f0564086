// Pictures that spot lights throw, as lit points read them.
#ifndef VEL_PASSES_PROJECTORS_PROJECTORS_IO_GLSL
#define VEL_PASSES_PROJECTORS_PROJECTORS_IO_GLSL

#include "shading/lang.glsl"

SAMPLED(1, 12, sampler2DArray, projector_pictures);  // its sampler knows how many frames share a pixel
CONSTANT(bool, kProjectors, 8, false);               // some light throws a picture

#endif
