#pragma once

#include "graph/graph.hpp"
#include "passes/local_shadows/keeper.hpp"
#include "upload/gpu_scene.hpp"

namespace velarium::local_shadows {

// Of the atlas, and of its veils.
inline constexpr std::uint64_t kDepthBytes = 4, kVeilBytes = 8;  // a texel

// Maps of depth of point and spot lights in one image, which is kept from picture to picture while there are any.
struct Maps {
  gpu::Image atlas;            // depth, reversed: 1 near the light, 0 far; D32F
  gpu::Image veils;            // beside it: shading/translucency.glsl, RGBA16F; null where nothing is veiled
  std::vector<MapDraw> draws;  // that this picture needs
  MapKeeper keeper;            // of what the atlas holds, where settings.updates bounds the draws
  std::uint64_t scene_id = 0;  // of what the keeper speaks of
};

// Plans the maps of a picture, and tells the lights where to find theirs: before the first of its frames. Returns how
// many lights that should have maps have none, as the atlas has no room for them or settings.updates no time. Throws
// Error(usage) where the device has no images as large as the atlas.
std::uint32_t prepare(Maps& maps, gpu::Device& device, upload::SceneTables& tables, const Viewer& viewer,
                      const Settings& settings);

struct Inputs {
  const upload::SceneTables& scene;
  Maps& maps;
  bool first = true;  // the first frame of a picture draws, the others read
};

struct Outputs {
  graph::GraphImage
      atlas;  // for GpuLight::shadow_view and SceneTables::shadow_views; version 0 where no light has a map
  graph::GraphImage veils;  // version 0 where nothing translucent stands in a light's way
};

[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in, const Settings& settings);

}  // namespace velarium::local_shadows
