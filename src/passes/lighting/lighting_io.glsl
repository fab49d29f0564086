// What tiled lighting hands on to passes that shade.
#ifndef VEL_PASSES_LIGHTING_LIGHTING_IO_GLSL
#define VEL_PASSES_LIGHTING_LIGHTING_IO_GLSL

#include "shading/lang.glsl"

TABLE(1, 3, ForwardListBuffer, uint forward_lists[]);  // bit masks in light order, tile after tile

#endif
