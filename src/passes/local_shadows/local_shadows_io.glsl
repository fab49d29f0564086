// Shadow maps of point and spot lights, as lit points read them.
#ifndef VEL_PASSES_LOCAL_SHADOWS_LOCAL_SHADOWS_IO_GLSL
#define VEL_PASSES_LOCAL_SHADOWS_LOCAL_SHADOWS_IO_GLSL

#include "shading/lang.glsl"
#include "shading/shadow_atlas.glsl"

SAMPLED_DEPTH(1, 5, texture2D, shadow_atlas);                  // all views side by side, reversed depth
SAMPLED(1, 14, texture2DArray, local_translucency);            // beside it, one layer: shading/translucency.glsl
TABLE(1, 7, ShadowViewBuffer, ShadowView shadow_views[]);
TABLE(1, 6, LightShadowBuffer, uint first_shadow_view[]);      // by light: 1 + its first of shadow_views, 0: it has no map
CONSTANT(uint, kLocalShadowTaps, 7, 0u);                       // 0: no light has a map; 1: all that have one are points
CONSTANT(bool, kLocalTranslucency, 17, false);                 // BLEND surfaces stand in some view

#endif
