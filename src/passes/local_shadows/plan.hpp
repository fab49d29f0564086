#pragma once

// From lights to maps: which views are drawn, where in the atlas, and how shaders find them.

#include "passes/local_shadows/atlas_allocator.hpp"
#include "passes/local_shadows/views.hpp"

#include "shading/host.hpp"

namespace velarium::local_shadows {

// A map to be drawn.
struct MapDraw {
  Tile tile;
  glm::mat4 clip_from_world{1.0f};  // from the device's world space
  std::vector<glm::dvec4> planes;   // of what the map sees: world space, inward normals
  bool translucent = false;         // do BLEND surfaces stand in it?
};

struct Plan {
  std::vector<shading::ShadowView> views;  // 1 or 6 a light that has a map
  std::vector<std::uint32_t> first_view;   // by light: 1 + its first of `views`, 0: it has no map
  std::vector<MapDraw> draws;
};

// A view with its place in the atlas: nothing where it got none, and then its light shines through.
struct PlacedView {
  View view;
  std::optional<Tile> tile;
  bool redraw = true;
};

// Sizes by coverage, shrunk to fit, packed from the largest to the smallest. The same views give the same places.
[[nodiscard]] std::vector<PlacedView> place_views(const std::vector<View>& views, const Settings& settings);

// Precondition: the views are in the order of wanted_views().
[[nodiscard]] Plan make_plan(const std::vector<PlacedView>& placed, std::span<const shading::GpuLight> lights,
                             const glm::dvec3& origin, std::uint32_t atlas_side);

}  // namespace velarium::local_shadows
