// What automatic exposure binds: partial sums, then their resolution.
#ifndef VEL_PASSES_EXPOSURE_IO_GLSL
#define VEL_PASSES_EXPOSURE_IO_GLSL

#include "shading/lang.glsl"

struct PartialPush {
  float frame_weight;  // 1 / number of frames
};
struct ResolvePush {
  float scale;  // 2^stops
};
SAMPLED(0, 0, texture2D, frame_sum);
OUT_TABLE(0, 1, Partials, vec2 partials[]);  // sum of weighted log2, of weights
OUT_TABLE(0, 2, Exposure, float exposure);

#endif
