#pragma once

#include "passes/local_shadows/shadow_cache.hpp"
#include "passes/map_demand.hpp"

#include <velarium/engine.hpp>

#include <string>
#include <vector>

namespace velarium::local_shadows {

// Maps of depth of point and spot lights in one image, which is kept from picture to picture while there are any.
struct State {
  gpu::Image atlas;         // depth, reversed: 1 near the light, 0 far; D32F; null where no light has a map
  gpu::Image translucency;  // beside it: shading/translucency.glsl, RGBA16F; null where it is not needed
  std::vector<shading::ShadowView> views;
  std::vector<std::uint32_t> first_view;  // by light: 1 + its first of `views`, 0: it has no map
  std::vector<MapDraw> draws;             // that this picture needs
  ShadowCache keeper;                     // of what the atlas holds, where settings.updates bounds the draws
  std::uint64_t scene_id = 0;             // of what the keeper speaks of
  std::uint32_t without_map = 0;          // lights that should have a map and have none

  // Plans the maps of a picture before the first of its frames. Throws Error(usage) where the device has no images as
  // large as the atlas.
  void prepare(gpu::Device& device, const upload::Tables& tables, const Viewer& viewer, const Settings& settings);
  // A sentence where the atlas has no room for some light's maps, or settings.updates no time; else empty.
  [[nodiscard]] std::string note() const;
  [[nodiscard]] std::vector<MapMemory> memory() const;
};

// Translucent casters and lights that cast shadows count wherever they stand.
[[nodiscard]] passes::MapDemand demand(const upload::Tables& tables, const Settings& settings);

}  // namespace velarium::local_shadows
