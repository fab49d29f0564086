#pragma once

#include "gpu/gpu_context.hpp"
#include "scene/snapshot.hpp"
#include "upload/draws.hpp"
#include "upload/projectors.hpp"
#include "upload/textures.hpp"
#include "upload/vertices.hpp"

#include <memory>
#include <vector>

namespace velarium::upload {

// Vertices of many primitives, one after the other.
struct VertexStreams {
  gpu::Buffer positions, attributes;
};

// Those that skins and morph targets of a snapshot have moved.
struct DeformedVertices {
  VertexStreams vertices;
  std::vector<std::int32_t> first;  // by index into SceneSnapshot::deformed
};

[[nodiscard]] DeformedVertices make_deformed(gpu::Device& device, const scene::Scene& scene,
                                             const scene::SceneSnapshot& snapshot);

// The parts of a scene that do not change with time or camera, on the device.
// The scene tables must outlive it.
class GpuScene {
 public:
  GpuScene(gpu::Device& device, const scene::Scene& scene);

  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  // From 1 on, another one for each that this process makes: what is kept of one is not mistaken for another's, which
  // may stand where it stood.
  [[nodiscard]] std::uint64_t id() const { return id_; }
  [[nodiscard]] const Textures& textures() const { return textures_; }
  [[nodiscard]] const gpu::Buffer& materials() const { return materials_; }
  [[nodiscard]] const Projectors& projectors() const { return projectors_; }

  // Where a primitive lies in the streams and the indices.
  struct Range {
    std::uint32_t first_index = 0, index_count = 0;
    std::int32_t first_vertex = 0;
  };
  [[nodiscard]] const Range& range(std::uint32_t primitive) const { return ranges_[primitive]; }
  [[nodiscard]] const VertexStreams& vertices() const { return vertices_; }
  [[nodiscard]] const gpu::Buffer& indices() const { return indices_; }

 private:
  void upload_geometry();

  gpu::Device& device_;
  const scene::Scene& scene_;
  std::uint64_t id_;
  Textures textures_;
  gpu::Buffer materials_;
  Projectors projectors_;
  VertexStreams vertices_;
  gpu::Buffer indices_;
  std::vector<Range> ranges_;  // by primitive
};

// How textures are filtered.
struct TextureQuality {
  float lod_bias = 0.0f;
  float anisotropy = 1.0f;
};

// The textures and factors of a material: descriptor set 2, upload/material_io.glsl.
[[nodiscard]] gpu::Bindings material_bindings(gpu::SamplerCache& samplers, const GpuScene& scene,
                                              const TextureQuality& quality, std::uint32_t material);

}  // namespace velarium::upload
