#ifndef VEL_SHADING_SURFACE_GLSL
#define VEL_SHADING_SURFACE_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"
#include "shading/smoothness.glsl"

// The stencil's eight bits: three of the material class, one of surfaces that take decals, one of near objects (drawn for
// themselves before the scene), three of the ambient region. What no technique writes yet is 0.
const uint kStencilClass = 0x07u;
const uint kStencilTakesDecals = 0x08u;
const uint kStencilNear = 0x10u;
const uint kStencilRegionShift = 5u;

// What shares the G-buffer's aliased channels.
const uint kClassStandard = 0u;       // occlusion, coloured specular
const uint kClassTransmittance = 1u;  // transmittance, grey specular
const uint kClassSubsurface = 2u;     // as standard; its diffuse light is blurred
const uint kClassUnlit = 3u;          // emission alone

// A point of a surface, ready to be lit: exactly what the G-buffer keeps of a material.
struct Surface {
  vec3 normal_ws;  // unit
  vec3 albedo;     // diffuse, linear, 0..1
  vec3 f0;         // specular reflectance at normal incidence, linear, 0..1
  float smoothness;
  float occlusion;           // share of ambient light that arrives, 0..1
  float transmittance_luma;  // Y, and (Cb, Cr) below, of the light let through, as specular_encoding.glsl defines them
  vec2 transmittance_chroma;
  uint material_class;
};

// Reflectance at normal incidence from air into a dielectric of this index [Fresnel; KHR_materials_ior].
// An index of 0 gives 1: the extension's way to ask for a perfect reflector.
FN float dielectric_f0_from_ior(float ior) {
  require(ior >= 0.0f);
  float r = (ior - 1.0f) / (ior + 1.0f);
  return r * r;
}

// The metallic-roughness material of glTF 2.0 (appendix B) with KHR_materials_ior and KHR_materials_specular.
// dielectric_f0_tint: specular * specular_color; the product with dielectric_f0 is clamped to 1.
//
// glTF mixes a finished dielectric and a finished metal: its diffuse light is base (1 - metallic) (1 - F) with the
// dielectric's F. diffuse_share() knows only the mixed f0. As 1 - F is proportional to 1 - f0 under Schlick's
// approximation, the ratio of the two belongs into the albedo, exactly; it never lifts it above the base colour.
FN Surface surface_from_metal_rough(vec3 base_color, float metallic, float perceptual_roughness, float dielectric_f0,
                                    vec3 dielectric_f0_tint, vec3 normal_ws, float occlusion) {
  vec3 dielectric = min(dielectric_f0 * dielectric_f0_tint, vec3(1.0f));
  Surface s;
  s.normal_ws = normal_ws;
  s.f0 = mix(dielectric, base_color, metallic);
  float mixed_share = 1.0f - max_component(s.f0);
  float dielectric_share = (1.0f - metallic) * (1.0f - max_component(dielectric));
  s.albedo = base_color * min(dielectric_share / max(mixed_share, 1e-6f), 1.0f);
  s.smoothness = smoothness_from_alpha(alpha_from_perceptual_roughness(perceptual_roughness));
  s.occlusion = occlusion;
  s.transmittance_luma = 0.0f;
  s.transmittance_chroma = vec2(0.0f);
  s.material_class = kClassStandard;
  return s;
}

#endif
