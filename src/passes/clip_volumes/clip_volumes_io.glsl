// Volumes that lights end at, as lit points read them.
#ifndef VEL_PASSES_CLIP_VOLUMES_CLIP_VOLUMES_IO_GLSL
#define VEL_PASSES_CLIP_VOLUMES_CLIP_VOLUMES_IO_GLSL

#include "shading/lang.glsl"

TABLE(1, 13, ClipVolumeBuffer, vec4 clip_records[]);  // upload::ClipVolumeTable
CONSTANT(bool, kClipVolumes, 9, false);              // some light ends at a volume

#endif
