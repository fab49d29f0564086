// Contact shadows of lamps. GLSL only.
#ifndef VEL_PASSES_LIGHTING_LAMP_CONTACT_GLSL
#define VEL_PASSES_LIGHTING_LAMP_CONTACT_GLSL

#include "upload/gbuffer_point.glsl"
#include "upload/light_lists.glsl"

#include "upload/contact_shadows.glsl"

// Where a lamp has a map that is too coarse, or none: the side of its texels at the point, metres; 0 where no ray is to
// be sent.
float contact_texel(ShadingPoint p, uint lamp) {
  GpuLight l = lights[lamp];
  if (kLocalShadows != 0u && l.shadow_view != 0u) return local_texel(l, p.position_ws);
  bool in_mask = kSunShadows != 0u && lamp == frame.sun_light;
  bool asked = kContactWithoutMap != 0u && (l.flags & kLightCastsShadow) != 0u && !in_mask;
  return asked ? kUnboundedRadius : 0.0;
}

// What surfaces right beside the point hide of the pixel's light, of which lamps are a part.
vec3 hidden_by_contact(ShadingPoint p, ivec2 pixel, float depth, LampLight lamps, vec3 light) {
  float weight = contact_weight(luminance(lamps.largest), luminance(light));
  if (kContactShadows == 0u || weight == 0.0) return vec3(0.0);
  uint lamp = lamp_of_key(lamps.key);
  GpuLight l = lights[lamp];
  vec3 to_light = l.position_range.xyz - p.position_ws;
  float distance = is_directional(l) ? kUnboundedRadius : length(to_light);
  vec3 wi = is_directional(l) ? -l.direction.xyz : to_light / max(distance, kMinLightDistance);
  ContactReceiver receiver = contact_receiver_at(pixel, depth, p.position_ws, p.surface.normal_ws);
  float visible = contact_visibility(receiver, wi, distance, contact_texel(p, lamp));
  return (weight * (1.0 - visible)) * lamps.largest;
}

#endif
