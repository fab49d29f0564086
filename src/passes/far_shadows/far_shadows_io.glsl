// The far cascade: one map of the whole scene from the sun, as lit points read it.
#ifndef VEL_PASSES_FAR_SHADOWS_FAR_SHADOWS_IO_GLSL
#define VEL_PASSES_FAR_SHADOWS_FAR_SHADOWS_IO_GLSL

#include "shading/lang.glsl"
#include "shading/cascades.glsl"

struct FarCascade {
  Cascade cascade;
  float normal_offset;  // texels
  float snap;           // how far beside its plane a surface may be seen, pixels
};
CHECK_LAYOUT(FarCascade, normal_offset, 48);

const uint kNoFarShadow = 0u;  // kFarShadow, as enum FarSun
const uint kFarVariance = 1u;  // layer 0: mean, layer 1: mean square of depth away from the sun, from the map's middle
const uint kFarStatic = 2u;    // depth, of what never moves

SAMPLED(1, 16, texture2DArray, far_moments);       // of kFarVariance
SAMPLED_DEPTH(1, 17, texture2DArray, far_depths);  // of kFarStatic
TABLE(1, 20, FarBuffer, FarCascade far);
CONSTANT(uint, kFarShadow, 15, 0u);                // what there is beyond the cascades

#endif
