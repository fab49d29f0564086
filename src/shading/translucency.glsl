// Light through blended surfaces.
#ifndef VEL_SHADING_TRANSLUCENCY_GLSL
#define VEL_SHADING_TRANSLUCENCY_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"

// Base colours darker than this have no hue to speak of: that of the darkest paints (a black's diffuse reflectance).
const float kLeastHue = 0.04f;

// glTF's alpha is coverage: a share 1 - alpha of the light passes a BLEND surface, whatever its colour. Cloth and glass
// dye what passes, the denser the more, so the hue of base_color (0..1) comes in by alpha. Grey sheets, from black to
// white, are as the specification has them, and coloured ones never let more pass.
FN vec3 blend_dye(vec3 base_color, float alpha) {
  vec3 hue = (base_color + vec3(kLeastHue)) / (max_component(base_color) + kLeastHue);
  return mix(vec3(1.0f), hue, alpha);
}

// What passes of light that a BLEND surface stands in the way of; alpha in 0..1.
FN vec3 blend_transmittance(vec3 base_color, float alpha) {
  require(alpha >= 0.0f && alpha <= 1.0f);
  return (1.0f - alpha) * blend_dye(base_color, alpha);
}

#endif
