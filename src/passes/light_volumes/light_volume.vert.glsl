#version 460
#extension GL_GOOGLE_include_directive : require

// What is drawn for a light: gl_InstanceIndex. Flat shapes lie at infinity, so that they cover surfaces and no sky.

#include "shading/light_volumes.glsl"
#include "shading/sampling.glsl"
#include "upload/gpu_structs.glsl"

layout(set = 0, binding = 0, std430) readonly buffer FrameBuffer { FrameUniforms frame; };
layout(set = 0, binding = 6, std430) readonly buffer BoundsBuffer { vec4 light_bounds[]; };   // view space spheres
layout(set = 1, binding = 2, std430) readonly buffer LightBuffer { GpuLight lights[]; };
layout(push_constant) uniform Draw { uint shape; };

layout(location = 0) flat out uint out_light;

const uint kShapeScreen = 0u;   // light_volumes::Shape
const uint kShapeQuad = 1u;
const uint kShapeSphere = 2u;

vec4 flat_corner(ScreenBounds bounds, uint vertex) {
  vec2 corner = vec2(vertex & 1u, vertex >> 1u);
  return vec4(mix(bounds.low, bounds.high, corner), 0.0, 1.0);
}

vec3 sphere_point(vec4 bounds, uint vertex) {
  vec3 point_vs = bounds.xyz + bounds.w * sphere_volume_point(vertex);
  return transpose(mat3(frame.view_from_world)) * point_vs;
}

vec3 cone_point(GpuLight l, uint vertex) {
  vec3 point = light_cull_radius(l) * cone_volume_point(vertex, l.cone.z);
  return l.position_range.xyz + from_tangent_space(point, l.direction.xyz);
}

void main() {
  uint light = uint(gl_InstanceIndex), vertex = uint(gl_VertexIndex);
  out_light = light;
  vec4 bounds = light_bounds[light];
  if (shape == kShapeScreen)
    gl_Position = flat_corner(ScreenBounds(vec2(-1.0), vec2(1.0)), vertex);
  else if (shape == kShapeQuad)
    gl_Position =
        flat_corner(sphere_screen_bounds(bounds.xyz, bounds.w, frame.ndc_to_view, frame.perspective), vertex);
  else if (shape == kShapeSphere)
    gl_Position = frame.clip_from_world * vec4(sphere_point(bounds, vertex), 1.0);
  else
    gl_Position = frame.clip_from_world * vec4(cone_point(lights[light], vertex), 1.0);
}
