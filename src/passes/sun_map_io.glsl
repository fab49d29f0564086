// What all maps of the sun share.
#ifndef VEL_PASSES_SUN_MAP_IO_GLSL
#define VEL_PASSES_SUN_MAP_IO_GLSL

#include "shading/lang.glsl"

CONSTANT(uint, kSunShadowTaps, 13, 32u);  // of the widest penumbra; even

#endif
