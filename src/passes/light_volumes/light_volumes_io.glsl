// What light volumes bind besides the G-buffer and the illumination.
#ifndef VEL_PASSES_LIGHT_VOLUMES_IO_GLSL
#define VEL_PASSES_LIGHT_VOLUMES_IO_GLSL

#include "shading/lang.glsl"

const uint kShapeScreen = 0u;  // VolumePush::shape, light_volumes::Shape
const uint kShapeQuad = 1u;
const uint kShapeSphere = 2u;
const uint kShapeCone = 3u;

struct VolumePush {
  uint shape;
};
PUSH(VolumePush);
TABLE(0, 6, BoundsBuffer, vec4 light_bounds[]);  // view space spheres
CONSTANT(uint, kKind, 30, 0u);                   // light_volumes::VolumeDraw::kind

#endif
