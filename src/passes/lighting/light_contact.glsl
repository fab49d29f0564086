// Contact shadows of the light that a pixel gets most of. GLSL only.
#ifndef VEL_PASSES_LIGHTING_LIGHT_CONTACT_GLSL
#define VEL_PASSES_LIGHTING_LIGHT_CONTACT_GLSL

#include "passes/contact_shadows/read.glsl"
#include "passes/gbuffer/read.glsl"
#include "passes/lighting/read.glsl"

// Where a light has a map that is too coarse, or none: the side of its texels at the point, metres; 0 where no ray is to
// be sent.
float contact_texel(ShadingPoint p, uint index) {
  GpuLight l = lights[index];
  if (has_local_shadow(index)) return local_texel(l, index, p.position_ws);
  bool in_mask = kSunShadows && index == light_ranges.sun;
  bool asked = kContactWithoutMap && (l.flags & kLightCastsShadow) != 0u && !in_mask;
  return asked ? kUnboundedRadius : 0.0;
}

// What surfaces right beside the point hide of the pixel's light, of which punctual lights are a part.
vec3 hidden_by_contact(ShadingPoint p, ivec2 pixel, float depth, PunctualLight punctual, vec3 light) {
  float weight = contact_weight(luminance(punctual.largest), luminance(light));
  if (kContactSteps == 0u || weight == 0.0) return vec3(0.0);
  uint index = light_of_key(punctual.key);
  GpuLight l = lights[index];
  vec3 to_light = l.position_range.xyz - p.position_ws;
  float distance = is_directional(l) ? kUnboundedRadius : length(to_light);
  vec3 wi = is_directional(l) ? -l.direction.xyz : to_light / max(distance, kMinLightDistance);
  ContactReceiver receiver = contact_receiver_at(pixel, depth, p.position_ws, p.surface.normal_ws);
  float visible = contact_visibility(receiver, wi, distance, contact_texel(p, index));
  return (weight * (1.0 - visible)) * punctual.largest;
}

#endif
