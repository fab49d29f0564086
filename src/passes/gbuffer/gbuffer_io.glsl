// The G-buffer (shading/gbuffer.glsl) as later passes bind it.
#ifndef VEL_PASSES_GBUFFER_GBUFFER_IO_GLSL
#define VEL_PASSES_GBUFFER_GBUFFER_IO_GLSL

#include "shading/lang.glsl"

SAMPLED(0, 1, texture2D, gbuffer_normal);
SAMPLED(0, 2, texture2D, gbuffer_albedo);
SAMPLED(0, 3, texture2D, gbuffer_specular);
SAMPLED_DEPTH(0, 4, texture2D, gbuffer_depth);
SAMPLED(0, 5, utexture2D, gbuffer_stencil);

#endif
