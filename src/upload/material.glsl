// A material evaluated at a point: what the G-buffer pass and the forward pass share. GLSL only, for fragment shaders.
#ifndef VEL_UPLOAD_MATERIAL_GLSL
#define VEL_UPLOAD_MATERIAL_GLSL

#include "shading/specular_aa.glsl"
#include "shading/surface.glsl"
#include "upload/material_io.glsl"

// Interpolated over the triangle.
struct FragmentInput {
  vec3 normal_ws;    // null where the geometry has none
  vec4 tangent_ws;   // xyz null where there is none; w: sign of the bitangent
  vec4 uv;           // two sets
  vec4 color;
  bool front_facing;
};

vec4 sample_slot(sampler2D map, uint slot, vec4 uv) {
  if ((kSlots & (1u << slot)) == 0u) return vec4(1.0);
  TextureSlot s = material.slots[slot];
  vec2 set = s.uv_set == 0u ? uv.xy : uv.zw;
  return texture(map, vec2(dot(s.rows.xy, set), dot(s.rows.zw, set)) + s.offset);
}

vec4 material_base_color(FragmentInput f) {
  return material.base_color * f.color * sample_slot(base_color_map, kSlotBaseColor, f.uv);
}

vec3 material_emissive(FragmentInput f) {
  return material.emissive.rgb * sample_slot(emissive_map, kSlotEmissive, f.uv).rgb;
}

// KHR_materials_unlit, and points and lines without normals.
bool is_unlit(FragmentInput f) {
  return (material.flags & kMaterialUnlit) != 0u || dot(f.normal_ws, f.normal_ws) == 0.0;
}

// KHR_materials_unlit leaves out what glows; points and lines without normals do not (glTF 2.0, 3.9.7).
vec3 unlit_radiance(FragmentInput f, vec3 base_color) {
  return (material.flags & kMaterialUnlit) != 0u ? base_color : base_color + material_emissive(f);
}

// The shading normal, and how far the map's normals spread within the texels that were read.
struct MaterialNormal {
  vec3 normal_ws;
  float spread2;   // what they add to alpha^2
};

// Of the side that is seen (glTF 2.0, 3.9.6: back faces of double-sided materials turn it).
MaterialNormal material_normal(FragmentInput f) {
  vec3 n = normalize(f.normal_ws);
  float side = f.front_facing ? 1.0 : -1.0;
  bool mapped = (kSlots & (1u << kSlotNormal)) != 0u && dot(f.tangent_ws.xyz, f.tangent_ws.xyz) > 0.0;
  if (!mapped) return MaterialNormal(n * side, 0.0);
  vec4 texel = sample_slot(normal_map, kSlotNormal, f.uv);
  float scale = material.emissive.w;
  vec3 m = texel.xyz * 2.0 - 1.0;
  m.xy *= scale;
  // As MikkTSpace asks: interpolated vectors are used as they are, and the sum alone is normalised.
  vec3 bitangent = f.tangent_ws.w * cross(f.normal_ws, f.tangent_ws.xyz);
  vec3 sum = m.x * f.tangent_ws.xyz + m.y * bitangent + m.z * f.normal_ws;
  // Slopes grow with the scale, and so does their deviation.
  float spread = texel.a * scale;
  return MaterialNormal(normalize(sum) * side, kBakedNormalSpread ? spread * spread : 0.0);
}

Surface material_surface(FragmentInput f, vec3 base_color) {
  vec4 factors = material.metal_rough;
  vec4 specular = material.specular;
  vec4 metal_rough = sample_slot(metallic_roughness_map, kSlotMetallicRoughness, f.uv);
  float occlusion = sample_slot(occlusion_map, kSlotOcclusion, f.uv).r;
  float specular_weight = sample_slot(specular_map, kSlotSpecular, f.uv).a;
  vec3 specular_tint = sample_slot(specular_color_map, kSlotSpecularColor, f.uv).rgb;
  MaterialNormal normal = material_normal(f);
  float perceptual_roughness = factors.y * metal_rough.g;
  if ((kSlots & (1u << kSlotNormal)) != 0u)
    perceptual_roughness = sqrt(widened_alpha(perceptual_roughness * perceptual_roughness, normal.spread2));
  return surface_from_metal_rough(base_color, factors.x * metal_rough.b, perceptual_roughness, specular.w,
                                  specular.rgb * specular_tint * specular_weight, normal.normal_ws,
                                  1.0 + factors.z * (occlusion - 1.0));
}

#endif
