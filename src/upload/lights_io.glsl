// The lights of the scene, as passes that shade bind them.
#ifndef VEL_UPLOAD_LIGHTS_IO_GLSL
#define VEL_UPLOAD_LIGHTS_IO_GLSL

#include "shading/lang.glsl"
#include "upload/gpu_structs.glsl"

TABLE(1, 2, LightBuffer, GpuLight lights[]);
TABLE(1, 19, LightRangeBuffer, LightRanges light_ranges);

#endif
