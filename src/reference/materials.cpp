#include "reference/materials.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::reference {
namespace {

// log2 of the footprint in texels of the largest mip. The width across the ray is the footprint's shorter side where
// it falls slantwise: what is sharper than the longer one is averaged by the paths of the pixel.
float lod_of(const BoundTexture& texture, const SurfacePoint& p, float width_m) {
  const float texels_per_m2 = texture.texels_per_uv_area() * p.uv_area(texture.uv_set) / std::max(p.area_m2, 1e-30f);
  return 0.5f * std::log2(std::max(texels_per_m2 * width_m * width_m, 1e-30f));
}

glm::vec4 sample(const BoundTexture& texture, const SurfacePoint& p, const Footprint& footprint) {
  if (!texture) return glm::vec4(1.0f);
  return texture.sample(p.uv(texture.uv_set), lod_of(texture, p, footprint.width_m), footprint.choice);
}

}  // namespace

Materials::Materials(const scene::Scene& scene) : textures_(scene) {
  for (const scene::Material& material : scene.materials) table_.push_back(bound(material, textures_));
  table_.push_back(bound(default_, textures_));
}

Materials::Material Materials::bound(const scene::Material& source, const Textures& textures) {
  return {.source = &source,
          .base_color = textures.bind(source.base_color_texture, true),
          .metallic_roughness = textures.bind(source.metallic_roughness_texture, false),
          .normal = textures.bind(source.normal_texture, false),
          .emissive = textures.bind(source.emissive_texture, true),
          .specular = textures.bind(source.specular_texture, false),
          .specular_color = textures.bind(source.specular_color_texture, true)};
}

bool Materials::may_be_transparent(std::uint32_t material) const {
  return table_[material].source->alpha_mode != scene::AlphaMode::opaque;
}

bool Materials::may_emit(std::uint32_t material) const {
  const scene::Material& m = *table_[material].source;
  return m.unlit ? glm::vec3(m.base_color) != glm::vec3(0.0f) : m.emissive != glm::vec3(0.0f);
}

float Materials::opacity(const SurfacePoint& p, const Footprint& footprint) const {
  const Material& m = of(p);
  if (m.source->alpha_mode == scene::AlphaMode::opaque) return 1.0f;
  const float alpha = base_color(m, p, footprint).w;
  if (m.source->alpha_mode == scene::AlphaMode::mask) return alpha < m.source->alpha_cutoff ? 0.0f : 1.0f;
  return std::clamp(alpha, 0.0f, 1.0f);
}

glm::vec3 Materials::emission(const SurfacePoint& p, const Footprint& footprint) const {
  const Material& m = of(p);
  if (m.source->unlit) return base_color(m, p, footprint);
  if (m.source->emissive == glm::vec3(0.0f)) return glm::vec3(0.0f);
  return m.source->emissive * glm::vec3(sample(m.emissive, p, footprint));
}

Look Materials::look(const SurfacePoint& p, bool front, const Footprint& footprint) const {
  const Material& m = of(p);
  const scene::Material& source = *m.source;
  // The G-buffer's range: vertex colours may exceed it.
  const glm::vec3 color = glm::clamp(glm::vec3(base_color(m, p, footprint)), 0.0f, 1.0f);
  Look look;
  look.unlit = source.unlit;
  if (front || source.double_sided) look.emission = emission(p, footprint);
  const glm::vec4 metal_rough = sample(m.metallic_roughness, p, footprint);
  const float specular = source.specular * sample(m.specular, p, footprint).w;
  const glm::vec3 tint = source.specular_color * glm::vec3(sample(m.specular_color, p, footprint));
  look.surface = shading::surface_from_metal_rough(
      color, source.metallic * metal_rough.z, source.perceptual_roughness * metal_rough.y,
      shading::dielectric_f0_from_ior(source.ior), tint * specular, shading_normal(m, p, front, footprint), 1.0f);
  return look;
}

glm::vec4 Materials::base_color(const Material& m, const SurfacePoint& p, const Footprint& footprint) {
  return m.source->base_color * p.color() * sample(m.base_color, p, footprint);
}

glm::vec3 Materials::shading_normal(const Material& m, const SurfacePoint& p, bool front, const Footprint& footprint) {
  const float side = front ? 1.0f : -1.0f;
  const glm::vec3 interpolated = p.normal_ws();
  // Normals that cancel, or that the file left null, give the flat one.
  const float squared = glm::dot(interpolated, interpolated);
  if (!(squared > 1e-20f)) return side * p.geometric_normal_ws;
  const glm::vec4 tangent = m.normal ? p.tangent_ws() : glm::vec4(0.0f);
  const glm::vec3 along_u(tangent);
  if (along_u == glm::vec3(0.0f)) return (side / std::sqrt(squared)) * interpolated;
  glm::vec3 mapped = glm::vec3(sample(m.normal, p, footprint)) * 2.0f - 1.0f;
  mapped.x *= m.source->normal_scale;
  mapped.y *= m.source->normal_scale;
  // As MikkTSpace asks: interpolated vectors are used as they are, and the sum alone is normalised.
  const glm::vec3 along_v = tangent.w * glm::cross(interpolated, along_u);
  const glm::vec3 sum = mapped.x * along_u + mapped.y * along_v + mapped.z * interpolated;
  const float length = glm::length(sum);
  return length > 0.0f ? (side / length) * sum : side * p.geometric_normal_ws;
}

}  // namespace velarium::reference
