// What the mean of frames binds.
#ifndef VEL_PASSES_AVERAGE_IO_GLSL
#define VEL_PASSES_AVERAGE_IO_GLSL

#include "shading/lang.glsl"

struct AveragePush {
  float frame_weight;  // 1 / number of frames
};
PUSH(AveragePush);
SAMPLED(0, 0, texture2D, frame_sum);
STORAGE(0, 1, rgba32f, writeonly image2D, mean);

#endif
