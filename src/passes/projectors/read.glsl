// Pictures that spot lights throw: a layer each of one array, soft edges and black borders included. GLSL only.
#ifndef VEL_PASSES_PROJECTORS_READ_GLSL
#define VEL_PASSES_PROJECTORS_READ_GLSL

#include "passes/projectors/projectors_io.glsl"
#include "shading/projector.glsl"
#include "upload/frame.glsl"

// What a spot light's picture lets through to a point; 1 for lights without one. wi: unit, towards the light. Texels that
// are smaller than a pixel there are averaged, both taken as they are seen head-on; the sampler's bias knows how many frames
// share a pixel.
vec3 projected(GpuLight l, vec3 position_ws, vec3 wi) {
  if (!kProjectors || l.projector_layer == 0u) return vec3(1.0);
  vec2 uv = projector_uv(l, wi);
  if (!in_projector(uv)) return vec3(0.0);
  float pixel_m = 2.0 * abs(frame.ndc_to_view.x) * frame.size.z * mix(1.0, length(position_ws - frame.eye.xyz), frame.perspective);
  float field_m = 2.0 * l.projector.w * distance(l.position_range.xyz, position_ws);
  float texels = pixel_m * float(textureSize(projector_pictures, 0).x) / max(field_m, 1e-20);
  return textureLod(projector_pictures, vec3(uv, float(l.projector_layer - 1u)), log2(max(texels, 1.0))).rgb;
}

#endif
