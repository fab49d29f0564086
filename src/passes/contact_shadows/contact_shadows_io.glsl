// Contact shadows: what passes that march through the depth buffer bind.
#ifndef VEL_PASSES_CONTACT_SHADOWS_CONTACT_SHADOWS_IO_GLSL
#define VEL_PASSES_CONTACT_SHADOWS_CONTACT_SHADOWS_IO_GLSL

#include "shading/lang.glsl"

struct ContactShadows {
  float longest;    // length of a ray, as a share of the picture's height
  float thickness;  // of what blocks it, the same
};

TABLE(1, 21, ContactShadowBuffer, ContactShadows contact);
CONSTANT(uint, kContactSteps, 10, 0u);           // most samples a ray takes; 0: there are no contact shadows
CONSTANT(bool, kContactWithoutMap, 16, false);  // of lights that have no map, too

#endif
