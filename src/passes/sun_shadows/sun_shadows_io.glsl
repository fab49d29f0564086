// The cascades of the sun, as lit points read them.
#ifndef VEL_PASSES_SUN_SHADOWS_SUN_SHADOWS_IO_GLSL
#define VEL_PASSES_SUN_SHADOWS_SUN_SHADOWS_IO_GLSL

#include "shading/lang.glsl"
#include "shading/cascades.glsl"

SAMPLED_DEPTH(1, 9, texture2DArray, sun_depths);      // a layer a cascade, reversed depth
SAMPLED(1, 15, texture2DArray, sun_translucency);     // the same, shading/translucency.glsl
TABLE(1, 11, SunBuffer, SunShadows sun);
CONSTANT(bool, kSunShadows, 18, false);               // light_ranges.sun casts shadows
CONSTANT(bool, kSunTranslucency, 12, false);          // BLEND surfaces stand in some cascade

#endif
