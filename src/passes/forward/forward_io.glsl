// What the forward pass itself specialises.
#ifndef VEL_PASSES_FORWARD_IO_GLSL
#define VEL_PASSES_FORWARD_IO_GLSL

#include "shading/lang.glsl"

CONSTANT(bool, kLights, 30, true);  // the scene has some

#endif
