// What the screen filter of specular anti-aliasing binds besides the G-buffer.
#ifndef VEL_PASSES_SPECULAR_AA_IO_GLSL
#define VEL_PASSES_SPECULAR_AA_IO_GLSL

#include "shading/lang.glsl"

struct SpecularAaPush {
  float share;  // of the variance between the taps: what one frame of the picture should see of it
  uint dim_dielectrics;
};
PUSH(SpecularAaPush);
STORAGE(0, 6, rgba8, image2D, specular);  // of the G-buffer, in place

#endif
