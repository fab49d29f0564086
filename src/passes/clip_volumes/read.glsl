// Lights that end at a volume, on the device. GLSL only.
#ifndef VEL_PASSES_CLIP_VOLUMES_READ_GLSL
#define VEL_PASSES_CLIP_VOLUMES_READ_GLSL

#include "passes/clip_volumes/clip_volumes_io.glsl"
#include "shading/clip_volume.glsl"
#include "upload/frame.glsl"

// Is this point of a surface in the volume that a light ends at? volume: GpuLight::clip_volume.
bool inside_clip_volume(uint volume, vec3 position_ws, vec3 normal_ws) {
  if (!kClipVolumes || volume == 0u) return true;
  vec3 point = clip_point(position_ws, normal_ws);
  ClipPlanes planes = clip_planes(clip_records[volume - 1u]);
  for (uint i = planes.first; i < planes.first + planes.count; ++i)
    if (!before_clip_plane(clip_records[i], point)) return false;
  return true;
}

#endif
