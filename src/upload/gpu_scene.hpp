#pragma once

#include "gpu/toolbox.hpp"
#include "scene/moment.hpp"
#include "upload/casters.hpp"
#include "upload/draws.hpp"
#include "upload/lights.hpp"
#include "upload/projectors.hpp"
#include "upload/textures.hpp"
#include "upload/vertices.hpp"

#include <memory>
#include <vector>

namespace velarium::upload {

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

  // Replaces the deformed vertices by those of this moment.
  void set_deformed(const scene::Moment& moment);

  // Binds the vertex streams (the shared ones, or the deformed ones) and the indices.
  void bind_vertices(VkCommandBuffer commands, bool deformed) const;
  void draw(VkCommandBuffer commands, const Draw& draw) const;
  // Of a draw whose triangles are sorted, with SceneTables::sorted_indices bound in place of the scene's.
  void draw_sorted(VkCommandBuffer commands, const Draw& draw) const;

 private:
  struct Range {
    std::uint32_t first_index = 0, index_count = 0;
    std::int32_t first_vertex = 0;
  };
  struct Streams {
    gpu::Buffer positions, attributes;
  };
  void upload_geometry();
  [[nodiscard]] std::int32_t first_vertex(const Draw& draw) const;

  gpu::Device& device_;
  const scene::Scene& scene_;
  std::uint64_t id_;
  Textures textures_;
  gpu::Buffer materials_;
  Projectors projectors_;
  Streams fixed_, deformed_;
  gpu::Buffer indices_;
  std::vector<Range> ranges_;                 // by primitive
  std::vector<std::int32_t> deformed_first_;  // by index into Moment::deformed
};

// What one picture draws: the view of a moment from one eye, on the device.
struct SceneTables {
  const GpuScene* gpu = nullptr;
  DrawList draws;
  gpu::Buffer objects;         // ObjectData
  gpu::Buffer sorted_indices;  // DrawList's; null where no draw is sorted
  CasterTable casters;         // empty where no light casts shadows
  gpu::Buffer caster_objects;  // ObjectData
  std::vector<GpuLight> host_lights;
  gpu::Buffer lights;        // the same
  gpu::Buffer light_bounds;  // view space spheres
  gpu::Buffer clip_volumes;  // ClipVolumeTable; null where no light ends at a volume
  LightRanges light_ranges;
  gpu::Buffer shadow_views;                // ShadowView, of point and spot lights; null where none has a map
  shading::SunShadows host_sun_shadows{};  // of no cascade where no sun casts shadows
  gpu::Buffer sun_shadows;                 // the same
  gpu::Buffer frame;                       // FrameUniforms, mapped: rewritten before each frame
  float texture_lod_bias = 0.0f;
  float anisotropy = 1.0f;
};

// The textures and factors of a material: descriptor set 2 of upload/material.glsl.
[[nodiscard]] gpu::Bindings material_bindings(gpu::SamplerCache& samplers, const SceneTables& tables,
                                              std::uint32_t material);

}  // namespace velarium::upload
