// The plane of what a pixel shows, from the depths beside it. GLSL only.
#ifndef VEL_PASSES_GBUFFER_READ_GEOMETRIC_NORMAL_GLSL
#define VEL_PASSES_GBUFFER_READ_GEOMETRIC_NORMAL_GLSL

#include "passes/gbuffer/read_depth_buffer.glsl"

// Device depth is linear across the picture on every plane. The next pixel belongs to this one's plane as far as the line
// through it and the one after leads here; where that one was not drawn, the line is level.
float distance_to_line(float here, float next, float after) {
  return next == 0.0 ? 1.0 : abs(after == 0.0 ? next - here : 2.0 * next - after - here);
}

// xyz: the way along the surface to the neighbour at this offset or the opposite one, whichever lies in its plane; null
// where neither was drawn. w: how far from that plane the neighbour's own line passes, as a share of the depth.
vec4 surface_step(ivec2 pixel, vec3 position, float here, ivec2 offset) {
  float after = device_depth_at(pixel + offset), before = device_depth_at(pixel - offset);
  float off_after = distance_to_line(here, after, device_depth_at(pixel + 2 * offset));
  float off_before = distance_to_line(here, before, device_depth_at(pixel - 2 * offset));
  if (after == 0.0 && before == 0.0) return vec4(0.0);
  bool forwards = before == 0.0 || (after != 0.0 && off_after < off_before);
  ivec2 neighbour = forwards ? pixel + offset : pixel - offset;
  vec3 step = position_at(neighbour, view_depth(forwards ? after : before, frame.depth_params)) - position;
  return vec4(forwards ? step : -step, (forwards ? off_after : off_before) / here);
}

// A plane whose line passes before or behind the pixel by more than four pixels' width is another surface's: on rails one
// or two pixels wide, where both neighbours are such, depths tell nothing. From 1 to 16 pixels the boxes under a sun gain;
// with one, leaves and capitals of the courtyard lose what the depths knew. In halves of a pixel's angle.
const float kBreak = 8.0;

// The normal of the surface itself, view space: what normal maps and interpolation say differs from how the maps see
// it. The shading normal where depths are broken; depths of orthographic views are no share of the distance and count as
// whole. position: of the pixel, view space.
vec3 geometric_normal(ivec2 pixel, vec3 position, vec3 shading_normal) {
  float here = device_depth_at(pixel);
  vec4 down = surface_step(pixel, position, here, ivec2(0, 1)), right = surface_step(pixel, position, here, ivec2(1, 0));
  vec3 n = cross(down.xyz, right.xyz);
  float squared = dot(n, n);
  float half_pixel = abs(frame.ndc_to_view.x) * frame.size.z;
  bool known = frame.perspective < 0.5 || max(down.w, right.w) < kBreak * half_pixel;
  return squared > 0.0 && known ? n * inversesqrt(squared) : shading_normal;
}

#endif
