// Convex volumes that lights end at [Tatarchuk et al. 2012, Secrets of CryENGINE 3: "Clip Boxes / Volumes"]: what keeps
// a light without shadows from shining through a wall. An inside is the set of points before every plane of a volume.
#ifndef VEL_SHADING_CLIP_VOLUME_GLSL
#define VEL_SHADING_CLIP_VOLUME_GLSL

#include "shading/lang.glsl"

// How far before a surface it is asked whether the surface lies inside, as a share of its distance from the eye. A wall
// often lies in a plane of the volume itself: then its two sides decide, and not the rounding of its depth: two steps of
// 2^-24 on lavapipe, up to 4e-4 on SwiftShader, whose vertices snap to 1/16 of a pixel. Half a pixel of a picture of 1000 lines.
const float kClipClearance = 5e-4f;

// Where the table of volumes holds the planes of one: its record begins with these two.
struct ClipPlanes {
  uint first, count;
};

FN ClipPlanes clip_planes(vec4 record) {
  ClipPlanes planes;
  planes.first = uint(record.x);
  planes.count = uint(record.y);
  return planes;
}

// The point that stands for a surface. position: relative to the eye, metres; normal: unit, on the side that is lit.
FN vec3 clip_point(vec3 position, vec3 normal) {
  return position + normal * (kClipClearance * length(position));
}

// plane: xyz: unit, inward; w: metres.
FN bool before_clip_plane(vec4 plane, vec3 point) {
  return dot(vec3(plane.x, plane.y, plane.z), point) + plane.w >= 0.0f;
}

#endif
