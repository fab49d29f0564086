// Light through blended surfaces.
#ifndef VEL_SHADING_TRANSLUCENCY_GLSL
#define VEL_SHADING_TRANSLUCENCY_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"

// Base colours darker than this have no hue to speak of: that of the darkest paints (a black's diffuse reflectance).
const float kLeastHue = 0.04f;

// glTF's alpha is coverage: a share 1 - alpha of the light passes a BLEND surface, whatever its colour. Cloth and glass
// tint what passes, the denser the more, so the hue of base_color (0..1) comes in by alpha. Grey sheets, from black to
// white, are as the specification has them, and coloured ones never let more pass.
FN vec3 blend_tint(vec3 base_color, float alpha) {
  vec3 hue = (base_color + vec3(kLeastHue)) / (max_component(base_color) + kLeastHue);
  return mix(vec3(1.0f), hue, alpha);
}

// What passes of light that a BLEND surface stands in the way of; alpha in 0..1.
FN vec3 blend_transmittance(vec3 base_color, float alpha) {
  require(alpha >= 0.0f && alpha <= 1.0f);
  return (1.0f - alpha) * blend_tint(base_color, alpha);
}

// A translucency map keeps of all BLEND surfaces along a way from the light: rgb what passes them together, a the depth
// of the one that is nearest to the light, reversed (1 nearest, 0 farthest). Where there is none: (1, 1, 1, 0).

// What is stored in halves is rounded by up to 5e-4 of itself; a surface must not lie behind itself for that.
const float kTranslucencyDepthError = 1e-3f;

// How far downhill the depth of a surface is taken, texels: a bilinear reading reaches one away on both axes, and there the
// surface's own plane is nearer to the light by both slopes, at most twice the steeper one.
const float kTranslucencySlope = 2.0f;

// The depth that the map keeps. slope: of `depth`, a texel.
FN float translucency_depth(float depth, vec2 slope) {
  return clamp(depth - kTranslucencySlope * max(abs(slope.x), abs(slope.y)), 0.0f, 1.0f);
}

// The least share of light that a receiver's own part is taken out of the map by: halves hold no less with two digits.
const float kLeastReceiverTransmittance = 1e-3f;

// What is left of light at a receiver of this depth, by a texel of the map: all of it before the surfaces. receiver: what
// passes the receiver itself, whose part in what stands before it does not count; 1 of what is not BLEND.
FN vec3 map_transmittance(vec4 texel, float depth, vec3 receiver) {
  bool behind = texel.w > depth * (1.0f + kTranslucencyDepthError);
  vec3 others = vec3(texel.x, texel.y, texel.z) / max(receiver, vec3(kLeastReceiverTransmittance));
  return behind ? min(others, vec3(1.0f)) : vec3(1.0f);
}

#endif
