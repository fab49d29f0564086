// The blur of depth moments.
#ifndef VEL_PASSES_FAR_BLUR_IO_GLSL
#define VEL_PASSES_FAR_BLUR_IO_GLSL

#include "shading/lang.glsl"

const int kMostTexels = 11;  // of BlurPush::weights

struct BlurPush {
  int radius;         // texels, less than kMostTexels
  float weights[11];  // by distance from the middle; their sum over all texels is 1
};
CHECK_LAYOUT(BlurPush, weights, 4);
PUSH(BlurPush);
SAMPLED(0, 0, texture2DArray, blur_source);
STORAGE(0, 1, r32f, writeonly image2DArray, blur_moments);  // layer 0: mean, layer 1: mean square
CONSTANT(bool, kColumns, 0, false);                         // else rows, of depth

#endif
