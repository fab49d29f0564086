// Area lights, as lit points read them.
#ifndef VEL_PASSES_AREA_LIGHTS_AREA_LIGHTS_IO_GLSL
#define VEL_PASSES_AREA_LIGHTS_AREA_LIGHTS_IO_GLSL

#include "shading/lang.glsl"

struct AreaLights {
  float min_highlight_alpha;  // lighting.min_highlight_alpha
};

TABLE(1, 22, AreaLightBuffer, AreaLights area_lights);
CONSTANT(bool, kAreaLights, 11, false);  // some light has a size, and is mirrored as round as it is

#endif
