// The vertex shader that every pass over shaded geometry shares.
#ifndef VEL_UPLOAD_GEOMETRY_GLSL
#define VEL_UPLOAD_GEOMETRY_GLSL

#include "upload/frame_io.glsl"
#include "upload/objects_io.glsl"

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec4 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_color;

#define VARYING out
#include "upload/varyings.glsl"

// Normals go by the matrix of cofactors, which is right for every matrix, mirrored and flat ones included.
vec3 transform_normal(vec3 row0, vec3 row1, vec3 row2, vec3 normal) {
  vec3 turned = vec3(dot(cross(row1, row2), normal), dot(cross(row2, row0), normal), dot(cross(row0, row1), normal));
  float handedness = dot(row0, cross(row1, row2)) < 0.0 ? -1.0 : 1.0;
  float squared = dot(turned, turned);
  return squared > 0.0 ? turned * (handedness * inversesqrt(squared)) : vec3(0.0);
}

vec3 transform_tangent(vec3 row0, vec3 row1, vec3 row2, vec3 tangent) {
  vec3 turned = vec3(dot(row0, tangent), dot(row1, tangent), dot(row2, tangent));
  float squared = dot(turned, turned);
  return squared > 0.0 ? turned * inversesqrt(squared) : vec3(0.0);
}

void main() {
  ObjectData object = objects[gl_InstanceIndex];
  vec4 row0 = object.world_from_object[0], row1 = object.world_from_object[1], row2 = object.world_from_object[2];
  vec4 position = vec4(in_position, 1.0);
  varying_position_ws = vec3(dot(row0, position), dot(row1, position), dot(row2, position));
  varying_normal_ws = transform_normal(row0.xyz, row1.xyz, row2.xyz, in_normal.xyz);
  float handedness = dot(row0.xyz, cross(row1.xyz, row2.xyz)) < 0.0 ? -1.0 : 1.0;
  varying_tangent_ws = vec4(transform_tangent(row0.xyz, row1.xyz, row2.xyz, in_tangent.xyz), in_tangent.w * handedness);
  varying_uv = in_uv;
  varying_color = in_color;
  gl_Position = frame.clip_from_world * vec4(varying_position_ws, 1.0);
  gl_PointSize = 1.0;
}

#endif
