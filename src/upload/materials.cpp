#include "upload/materials.hpp"

#include "upload/textures.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::upload {
namespace {

// KHR_texture_transform: uv' = T R S uv, where R = (cos, sin; -sin, cos).
TextureSlot gpu_slot(const scene::TextureRef& ref, const UvChoice& uv) {
  const float c = std::cos(ref.rotation), s = std::sin(ref.rotation);
  return {.rows = {c * ref.scale.x, s * ref.scale.y, -s * ref.scale.x, c * ref.scale.y},
          .offset = ref.offset,
          .uv_set = uv.place_of(ref.uv_set)};
}

GpuMaterial gpu_material(const scene::Material& m) {
  GpuMaterial result{};
  result.base_color = m.base_color;
  result.emissive = glm::vec4(m.emissive, m.normal_scale);
  result.metal_rough = {m.metallic, m.perceptual_roughness, m.occlusion_strength,
                        m.alpha_mode == scene::AlphaMode::mask ? m.alpha_cutoff : 0.0f};
  result.specular = glm::vec4(m.specular_color * m.specular, shading::dielectric_f0_from_ior(m.ior));
  result.flags = (m.unlit ? kMaterialUnlit : 0u) | (m.double_sided ? kMaterialDoubleSided : 0u);
  const auto slots = slots_of(m);
  const UvChoice uv = uv_choice(m);
  for (std::uint32_t i = 0; i < kSlotCount; ++i) result.slots[i] = gpu_slot(*slots[i], uv);
  return result;
}

}  // namespace

std::uint32_t slot_mask(const scene::Material& material) {
  std::uint32_t mask = 0;
  const auto slots = slots_of(material);
  for (std::uint32_t i = 0; i < kSlotCount; ++i) mask |= slots[i]->present() ? 1u << i : 0u;
  return mask;
}

UvChoice uv_choice(const scene::Material& material) {
  std::vector<std::uint32_t> used;
  for (const auto* ref : slots_of(material))
    if (ref->present() && std::find(used.begin(), used.end(), ref->uv_set) == used.end()) used.push_back(ref->uv_set);
  std::sort(used.begin(), used.end());
  if (used.empty()) return {};
  return {{used[0], used.size() > 1 ? used[1] : used[0]}};
}

std::vector<MaterialBlock> gpu_materials(const scene::Scene& scene) {
  std::vector<MaterialBlock> result;
  for (const auto& material : scene.materials) result.push_back({gpu_material(material)});
  result.push_back({gpu_material(material_or_default(scene, scene::kNone))});
  return result;
}

std::uint32_t material_index(const scene::Scene& scene, std::int32_t material) {
  return material == scene::kNone ? static_cast<std::uint32_t>(scene.materials.size())
                                  : static_cast<std::uint32_t>(material);
}

const scene::Material& material_or_default(const scene::Scene& scene, std::int32_t material) {
  static const scene::Material kDefault;
  return material == scene::kNone ? kDefault : scene.materials[static_cast<std::size_t>(material)];
}

}  // namespace velarium::upload
