// The sun's shadow mask, as deferred passes read it.
#ifndef VEL_PASSES_SUN_SHADOW_MASK_SUN_SHADOW_MASK_IO_GLSL
#define VEL_PASSES_SUN_SHADOW_MASK_SUN_SHADOW_MASK_IO_GLSL

#include "shading/lang.glsl"

SAMPLED(1, 8, texture2D, sun_shadow_mask);  // by pixel: the share of the sun that is hidden
CONSTANT(bool, kSunShadowMask, 6, false);   // the points that are lit are those of its pixels

#endif
