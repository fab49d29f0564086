// The depth buffer of the view, read by pixel. GLSL only.
#ifndef VEL_PASSES_GBUFFER_READ_DEPTH_BUFFER_GLSL
#define VEL_PASSES_GBUFFER_READ_DEPTH_BUFFER_GLSL

#include "passes/gbuffer/gbuffer_io.glsl"
#include "shading/depth.glsl"
#include "upload/frame.glsl"

// Device depth, 0 where nothing was drawn and outside the picture.
float device_depth_at(ivec2 pixel) {
  bool outside = any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(frame.size.xy)));
  return outside ? 0.0 : texelFetch(gbuffer_depth, pixel, 0).r;
}

// View depth, 0 where nothing was drawn and outside the picture.
float linear_depth_at(ivec2 pixel) {
  float device_depth = device_depth_at(pixel);
  return device_depth > 0.0 ? view_depth(device_depth, frame.depth_params) : 0.0;
}

// -1 to 1, y down.
vec2 ndc_of_pixel(ivec2 pixel) {
  return (vec2(pixel) + 0.5) * frame.size.zw * 2.0 - 1.0;
}

// View space. depth: view depth.
vec3 position_at(ivec2 pixel, float depth) {
  return view_position(ndc_of_pixel(pixel), depth, frame.ndc_to_view, frame.perspective);
}

#endif
