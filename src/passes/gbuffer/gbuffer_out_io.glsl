// What the pass that draws the G-buffer binds.
#ifndef VEL_PASSES_GBUFFER_OUT_IO_GLSL
#define VEL_PASSES_GBUFFER_OUT_IO_GLSL

#include "shading/lang.glsl"

SAMPLED(1, 0, texture2D, normal_lengths);  // best-fit lengths, shading/normal_encoding.glsl
CONSTANT(bool, kAlphaTest, 30, false);     // MASK

#endif
