// Geometry seen from a light: its place alone, and for cutouts what their alpha needs. GLSL only, for vertex shaders.
#ifndef VEL_UPLOAD_CASTER_GLSL
#define VEL_UPLOAD_CASTER_GLSL

#include "upload/caster_io.glsl"
#include "upload/objects_io.glsl"

layout(location = 0) in vec3 in_position;

vec4 caster_position() {
  ObjectData object = objects[gl_InstanceIndex];
  vec4 position = vec4(in_position, 1.0);
  return push.clip_from_world * vec4(dot(object.world_from_object[0], position), dot(object.world_from_object[1], position),
                                dot(object.world_from_object[2], position), 1.0);
}

#endif
