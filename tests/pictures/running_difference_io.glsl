// A toy technique: what the frame before was less.
#ifndef VEL_TESTS_RUNNING_DIFFERENCE_IO_GLSL
#define VEL_TESTS_RUNNING_DIFFERENCE_IO_GLSL

#include "shading/lang.glsl"

SAMPLED(0, 0, texture2D, before);
STORAGE(0, 1, rgba32f, writeonly image2D, after);  // for the frame to come
STORAGE(0, 2, rgba32f, image2D, sum);              // in: this frame; out: how it differs

#endif
