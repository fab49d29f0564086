// The samplers that all shaders share: descriptor set 3, which Context::bind() binds by itself. Images bring none of
// their own, as a stage of the poorest driver has 32 of them (docs/architecture.md).
#ifndef VEL_GPU_SAMPLERS_GLSL
#define VEL_GPU_SAMPLERS_GLSL

#include "shading/lang.glsl"

SAMPLER(3, 0, sampler, linear_sampler);           // all levels, clamped to the edge
SAMPLER(3, 1, sampler, nearest_sampler);          // the same of single texels; not every device filters 32-bit floats
SAMPLER(3, 2, sampler, equirect_sampler);         // linear; u, the azimuth, wraps around
SAMPLER(3, 3, samplerShadow, compare_sampler);    // 1: the reference is at or before what is stored, reversed; filtered

#endif
