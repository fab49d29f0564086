#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

// What is drawn for a light: gl_InstanceIndex. Flat shapes lie at infinity, so that they cover surfaces and no sky.

#include "passes/light_volumes/light_volumes_io.glsl"
#include "shading/light_volumes.glsl"
#include "shading/sampling.glsl"
#include "upload/frame.glsl"
#include "upload/lights_io.glsl"

layout(location = 0) flat out uint out_light;

vec4 flat_corner(ScreenBounds bounds, uint vertex) {
  vec2 corner = vec2(vertex & 1u, vertex >> 1u);
  return vec4(mix(bounds.low, bounds.high, corner), 0.0, 1.0);
}

vec3 sphere_point(vec4 bounds, uint vertex) {
  vec3 point_vs = bounds.xyz + bounds.w * sphere_volume_point(vertex);
  return transpose(view_rotation()) * point_vs + frame.eye.xyz;
}

vec3 cone_point(GpuLight l, uint vertex) {
  vec3 point = light_cull_radius(l) * cone_volume_point(vertex, l.cone.z);
  return l.position_range.xyz + from_tangent_space(point, l.direction.xyz);
}

void main() {
  uint light = uint(gl_InstanceIndex), vertex = uint(gl_VertexIndex);
  out_light = light;
  vec4 bounds = light_bounds[light];
  if (push.shape == kShapeScreen)
    gl_Position = flat_corner(ScreenBounds(vec2(-1.0), vec2(1.0)), vertex);
  else if (push.shape == kShapeQuad)
    gl_Position =
        flat_corner(sphere_screen_bounds(bounds.xyz, bounds.w, frame.ndc_to_view, frame.perspective), vertex);
  else if (push.shape == kShapeSphere)
    gl_Position = frame.clip_from_world * vec4(sphere_point(bounds, vertex), 1.0);
  else
    gl_Position = frame.clip_from_world * vec4(cone_point(lights[light], vertex), 1.0);
}
