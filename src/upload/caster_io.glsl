// What a caster is drawn into.
#ifndef VEL_UPLOAD_CASTER_IO_GLSL
#define VEL_UPLOAD_CASTER_IO_GLSL

#include "shading/lang.glsl"

struct CasterPush {
  mat4 clip_from_world;
};
PUSH(CasterPush);

#endif
