// Lights that end at a volume, on the device. GLSL only.
#ifndef VEL_UPLOAD_CLIP_VOLUMES_GLSL
#define VEL_UPLOAD_CLIP_VOLUMES_GLSL

#include "shading/clip_volume.glsl"

layout(set = 1, binding = 13, std430) readonly buffer ClipVolumeBuffer { vec4 clip_records[]; };  // ClipVolumeTable

layout(constant_id = 9) const uint kClipVolumes = 0u;  // 1: some light ends at a volume

// Is this point of a surface in the volume that a light ends at? volume: GpuLight::clip_volume.
bool inside_clip_volume(uint volume, vec3 position_ws, vec3 normal_ws) {
  if (kClipVolumes == 0u || volume == 0u) return true;
  vec3 point = clip_point(position_ws, normal_ws);
  ClipPlanes planes = clip_planes(clip_records[volume - 1u]);
  for (uint i = planes.first; i < planes.first + planes.count; ++i)
    if (!before_clip_plane(clip_records[i], point)) return false;
  return true;
}

#endif
