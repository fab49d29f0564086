// The view that a frame is drawn from: what every pass binds first.
#ifndef VEL_UPLOAD_FRAME_IO_GLSL
#define VEL_UPLOAD_FRAME_IO_GLSL

#include "shading/lang.glsl"
#include "upload/gpu_structs.glsl"

TABLE(0, 0, FrameBuffer, FrameUniforms frame);

#endif
