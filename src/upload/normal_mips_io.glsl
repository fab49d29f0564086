// One level of a normal map, made of the one above.
#ifndef VEL_UPLOAD_NORMAL_MIPS_IO_GLSL
#define VEL_UPLOAD_NORMAL_MIPS_IO_GLSL

#include "shading/lang.glsl"

struct NormalMipPush {
  uvec2 from_size;
  uvec2 to_size;
  uint from_first;  // means of the level above, from here on
  uint to_first;
  uint from_base;   // 1: the level above is level 0, which has no means yet
};
CHECK_LAYOUT(NormalMipPush, from_first, 16);
PUSH(NormalMipPush);
STORAGE(0, 0, rgba8, readonly image2D, base);  // level 0
STORAGE(0, 1, rgba8, writeonly image2D, level);
OUT_TABLE(0, 2, MeansBuffer, vec4 means[]);    // of all levels but the first

#endif
