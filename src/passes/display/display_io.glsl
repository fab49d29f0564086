// What the step from linear light to display values binds.
#ifndef VEL_PASSES_DISPLAY_IO_GLSL
#define VEL_PASSES_DISPLAY_IO_GLSL

#include "shading/lang.glsl"

struct DisplayPush {
  vec4 background;      // linear display light; w 1: lies behind, 0: there is none
  float frame_weight;   // 1 / number of frames
  uint seed;
};
CHECK_LAYOUT(DisplayPush, frame_weight, 16);
PUSH(DisplayPush);
SAMPLED(0, 0, texture2D, frame_sum);
TABLE(0, 1, Exposure, float exposure);
STORAGE(0, 2, rgba16ui, writeonly uimage2D, values);
CONSTANT(uint, kTonemap, 0, 0u);
CONSTANT(uint, kBits, 1, 8u);
CONSTANT(bool, kDither, 2, true);

#endif
