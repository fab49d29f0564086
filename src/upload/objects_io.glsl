// The instances of a draw, as vertex shaders bind them.
#ifndef VEL_UPLOAD_OBJECTS_IO_GLSL
#define VEL_UPLOAD_OBJECTS_IO_GLSL

#include "shading/lang.glsl"
#include "upload/gpu_structs.glsl"

TABLE(0, 1, ObjectBuffer, ObjectData objects[]);

#endif
