// How surfaces answer light.
#ifndef VEL_PASSES_ILLUMINATION_IO_GLSL
#define VEL_PASSES_ILLUMINATION_IO_GLSL

#include "shading/lang.glsl"

CONSTANT(uint, kModel, 1, 0u);             // kModelGltf, kModelRyse, kModelBlinnPhong
CONSTANT(bool, kMultiScatter, 2, true);

#endif
