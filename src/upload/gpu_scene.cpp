#include "upload/gpu_scene.hpp"

#include "core/jobs.hpp"
#include "upload/io.hpp"
#include "upload/materials.hpp"
#include "upload/transfer.hpp"

#include <algorithm>
#include <atomic>

namespace velarium::upload {
namespace {

constexpr VkBufferUsageFlags kVertexUsage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// Vertices of many primitives, one after the other.
struct PackedStreams {
  std::vector<glm::vec3> positions;
  std::vector<PackedAttributes> attributes;

  std::int32_t reserve(std::size_t vertices) {
    const auto first = static_cast<std::int32_t>(positions.size());
    positions.resize(positions.size() + vertices);
    attributes.resize(positions.size());
    return first;
  }
  void fill(std::int32_t first, const scene::Scene& scene, const scene::Primitive& primitive,
            const scene::VertexFrames& frames) {
    std::copy(frames.positions.begin(), frames.positions.end(), positions.begin() + first);
    const auto& material = material_or_default(scene, primitive.material);
    pack_attributes(primitive, frames, uv_choice(material),
                    std::span(attributes).subspan(static_cast<std::size_t>(first), frames.positions.size()));
  }
  [[nodiscard]] VertexStreams upload(gpu::Device& device) const {
    return {make_buffer(device, positions, kVertexUsage), make_buffer(device, attributes, kVertexUsage)};
  }
};

}  // namespace

GpuScene::GpuScene(gpu::Device& device, const scene::Scene& scene)
    : device_(device),
      scene_(scene),
      id_(next_id()),
      textures_(device, scene),
      materials_(make_buffer(device, gpu_materials(scene), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)),
      projectors_(make_projectors(device, scene)) {
  upload_geometry();
}

void GpuScene::upload_geometry() {
  PackedStreams streams;
  std::vector<std::uint32_t> indices;
  std::size_t index_count = 0;
  for (const auto& primitive : scene_.primitives) {
    ranges_.push_back({static_cast<std::uint32_t>(index_count), static_cast<std::uint32_t>(primitive.indices.size()),
                       streams.reserve(primitive.vertex_count())});
    index_count += primitive.indices.size();
  }
  indices.resize(index_count);
  parallel_for(scene_.primitives.size(), [&](std::size_t i) {
    const auto& primitive = scene_.primitives[i];
    streams.fill(ranges_[i].first_vertex, scene_, primitive, primitive.vertices);
    std::copy(primitive.indices.begin(), primitive.indices.end(), indices.begin() + ranges_[i].first_index);
  });
  vertices_ = streams.upload(device_);
  indices_ = make_buffer(device_, indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

DeformedVertices make_deformed(gpu::Device& device, const scene::Scene& scene, const scene::SceneSnapshot& snapshot) {
  DeformedVertices deformed{.first = std::vector<std::int32_t>(snapshot.deformed.size())};
  if (snapshot.deformed.empty()) return deformed;
  PackedStreams streams;
  for (std::size_t i = 0; i < snapshot.deformed.size(); ++i)
    deformed.first[i] = streams.reserve(snapshot.deformed[i].positions.size());
  for (const auto& instance : snapshot.instances) {
    if (instance.deformed == scene::kNone) continue;
    const auto i = static_cast<std::size_t>(instance.deformed);
    streams.fill(deformed.first[i], scene, scene.primitives[instance.primitive], snapshot.deformed[i]);
  }
  deformed.vertices = streams.upload(device);
  return deformed;
}

gpu::Bindings material_bindings(gpu::SamplerCache& samplers, const GpuScene& gpu_scene, const TextureQuality& quality,
                                std::uint32_t material) {
  const auto& scene = gpu_scene.scene();
  const bool is_default = material == scene.materials.size();
  const auto slots =
      slots_of(material_or_default(scene, is_default ? scene::kNone : static_cast<std::int32_t>(material)));
  gpu::Bindings bindings;
  for (std::uint32_t slot = 0; slot < kSlotCount; ++slot) {
    const auto bound = gpu_scene.textures().bound(*slots[slot], slot);
    bindings.sampled({io::base_color_map.set, io::base_color_map.binding + slot, io::base_color_map.type},
                     bound.image->view(),
                     samplers.get(sampler_desc(bound.sampler, quality.anisotropy, quality.lod_bias)));
  }
  bindings.buffer(io::MaterialBuffer, gpu_scene.materials(), material * sizeof(MaterialBlock), sizeof(GpuMaterial));
  return bindings;
}

}  // namespace velarium::upload
