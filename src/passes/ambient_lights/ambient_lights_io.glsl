// Lights that multiply what surrounds a point, as lit points read them.
#ifndef VEL_PASSES_AMBIENT_LIGHTS_AMBIENT_LIGHTS_IO_GLSL
#define VEL_PASSES_AMBIENT_LIGHTS_AMBIENT_LIGHTS_IO_GLSL

#include "shading/ambient_light.glsl"
#include "shading/lang.glsl"

struct AmbientLights {
  uint count;
};

TABLE(1, 23, AmbientLightBuffer, GpuAmbientLight ambient_lights[]);  // of the view, in the scene's order
TABLE(1, 24, AmbientLightsBuffer, AmbientLights ambient);
CONSTANT(bool, kAmbientLights, 14, false);                           // the view sees the volume of some

#endif
