#include "reference/materials.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::reference {

// Textures at one point. Most materials read all of theirs by one set of coordinates: the last one is kept.
class Materials::Reader {
 public:
  Reader(const SurfacePoint& p, const Footprint& footprint) : point(p), footprint_(footprint) {}

  [[nodiscard]] glm::vec4 read(const Slot& slot) {
    if (!slot.texture) return glm::vec4(1.0f);
    turn_to(slot.texture.uv_set);
    return slot.texture.sample(uv_, slot.log2_texels + log2_uv_, footprint_.choice);
  }

  // Of the largest mip, whatever the footprint. Means of normals are the normals of a smoother surface: what is
  // averaged is the light of many paths. Precondition: there is a texture.
  [[nodiscard]] glm::vec4 read_full_size(const Slot& slot) {
    turn_to(slot.texture.uv_set);
    return slot.texture.sample(uv_, 0.0f, footprint_.choice);
  }

  const SurfacePoint& point;

 private:
  void turn_to(std::uint32_t uv_set) {
    if (uv_set == set_) return;
    set_ = uv_set;
    uv_ = point.uv(set_);
    log2_uv_ = point.log2_uv(set_, footprint_.width_m);
  }

  const Footprint& footprint_;
  std::uint32_t set_ = scene::kMaxUvSets;  // none yet
  glm::vec2 uv_{0.0f};
  float log2_uv_ = 0.0f;
};

Materials::Materials(const scene::Scene& scene) : textures_(scene) {
  for (const scene::Material& material : scene.materials) table_.push_back(bound(material, textures_));
  table_.push_back(bound(default_, textures_));
}

Materials::Material Materials::bound(const scene::Material& source, const Textures& textures) {
  const auto slot = [&](const scene::TextureRef& ref, bool srgb) {
    const BoundTexture texture = textures.bind(ref, srgb);
    return Slot{texture, texture ? texture.log2_texels_per_uv() : 0.0f};
  };
  return {.source = &source,
          .base_color = slot(source.base_color_texture, true),
          .metallic_roughness = slot(source.metallic_roughness_texture, false),
          .normal = slot(source.normal_texture, false),
          .emissive = slot(source.emissive_texture, true),
          .specular = slot(source.specular_texture, false),
          .specular_color = slot(source.specular_color_texture, true)};
}

bool Materials::may_be_transparent(std::uint32_t material) const {
  return table_[material].source->alpha_mode != scene::AlphaMode::opaque;
}

bool Materials::may_emit(std::uint32_t material) const {
  const scene::Material& m = *table_[material].source;
  return m.unlit ? glm::vec3(m.base_color) != glm::vec3(0.0f) : m.emissive != glm::vec3(0.0f);
}

Transparency Materials::transparency(const SurfacePoint& p, const Footprint& footprint) const {
  const Material& m = of(p);
  if (m.source->alpha_mode == scene::AlphaMode::opaque) return {};
  Reader reader(p, footprint);
  const glm::vec4 color = base_color(m, reader);
  if (m.source->alpha_mode == scene::AlphaMode::mask) return {color.w < m.source->alpha_cutoff ? 0.0f : 1.0f};
  const glm::vec4 bounded = glm::clamp(color, 0.0f, 1.0f);
  return {bounded.w, shading::blend_tint(glm::vec3(bounded), bounded.w)};
}

glm::vec3 Materials::emission(const SurfacePoint& p, const Footprint& footprint) const {
  Reader reader(p, footprint);
  return emission(of(p), reader);
}

Look Materials::look(const SurfacePoint& p, bool front, const Footprint& footprint) const {
  const Material& m = of(p);
  const scene::Material& source = *m.source;
  Reader reader(p, footprint);
  // The G-buffer's range: vertex colours may exceed it.
  const glm::vec3 color = glm::clamp(glm::vec3(base_color(m, reader)), 0.0f, 1.0f);
  Look look;
  look.unlit = source.unlit;
  if (front || source.double_sided) look.emission = emission(m, reader);
  const glm::vec4 metal_rough = reader.read(m.metallic_roughness);
  const float specular = source.specular * reader.read(m.specular).w;
  const glm::vec3 tint = source.specular_color * glm::vec3(reader.read(m.specular_color));
  look.surface = shading::surface_from_metal_rough(
      color, source.metallic * metal_rough.z, source.perceptual_roughness * metal_rough.y,
      shading::dielectric_f0_from_ior(source.ior), tint * specular, shading_normal(m, front, reader), 1.0f);
  return look;
}

glm::vec4 Materials::base_color(const Material& m, Reader& reader) {
  return m.source->base_color * reader.point.color() * reader.read(m.base_color);
}

glm::vec3 Materials::emission(const Material& m, Reader& reader) {
  if (m.source->unlit) return base_color(m, reader);
  if (m.source->emissive == glm::vec3(0.0f)) return glm::vec3(0.0f);
  return m.source->emissive * glm::vec3(reader.read(m.emissive));
}

glm::vec3 Materials::shading_normal(const Material& m, bool front, Reader& reader) {
  const float side = front ? 1.0f : -1.0f;
  const glm::vec3 interpolated = reader.point.normal_ws(), flat = side * reader.point.geometric_normal_ws;
  // Normals that cancel, or that the file left null, give the flat one.
  const float squared = glm::dot(interpolated, interpolated);
  if (!(squared > 1e-20f)) return flat;
  const glm::vec4 tangent = m.normal.texture ? reader.point.tangent_ws() : glm::vec4(0.0f);
  const glm::vec3 along_u(tangent);
  if (along_u == glm::vec3(0.0f)) return (side / std::sqrt(squared)) * interpolated;
  glm::vec3 mapped = glm::vec3(reader.read_full_size(m.normal)) * 2.0f - 1.0f;
  mapped.x *= m.source->normal_scale;
  mapped.y *= m.source->normal_scale;
  // As MikkTSpace asks: interpolated vectors are used as they are, and the sum alone is normalised.
  const glm::vec3 along_v = tangent.w * glm::cross(interpolated, along_u);
  const glm::vec3 sum = mapped.x * along_u + mapped.y * along_v + mapped.z * interpolated;
  const float length = glm::length(sum);
  return length > 0.0f ? (side / length) * sum : flat;
}

}  // namespace velarium::reference
