// What the pass of the sun's shadow mask writes.
#ifndef VEL_PASSES_SUN_SHADOW_MASK_OUT_IO_GLSL
#define VEL_PASSES_SUN_SHADOW_MASK_OUT_IO_GLSL

#include "shading/lang.glsl"

STORAGE(0, 6, r32f, writeonly image2D, occlusion_out);

#endif
