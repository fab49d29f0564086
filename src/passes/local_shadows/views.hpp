#pragma once

// What the maps of lights look at, and how large they should be. Pure functions: places relative to the origin
// (upload::Tables).

#include "passes/local_shadows/screen_coverage.hpp"
#include "upload/view.hpp"

#include <velarium/settings.hpp>

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace velarium::local_shadows {

using Settings = velarium::Settings::local_shadows_settings;

// The picture that maps are made for.
struct Viewer {
  const upload::ViewMatrices& view;
  glm::uvec2 size{1};      // pixels
  glm::dvec3 origin{0.0};  // world space of the scene: of places
  [[nodiscard]] glm::dvec3 eye() const { return view.eye - origin; }
};

// Where a view's translucent casters stand.
struct TranslucentBounds {
  double nearest = 0.0;            // along forward, metres; 0: there is none
  glm::dvec2 low{0.0}, high{0.0};  // tangents to the right and down, without what filters need around them
};

// One view from one light, before it has a tile.
struct View {
  std::uint32_t light = 0;  // into the table of lights
  std::uint32_t face = 0;   // as shading::shadow_face() numbers them; 0 of a light that has one view
  glm::dvec3 position{0.0};
  std::array<glm::dvec3, 3> axes{};  // right, down, forward: unit, right-handed
  double half_tangent = 1.0;         // of what the light reaches, without what filters need around it
  double near = 0.0, reach = 0.0;    // along forward, metres
  float kernel = 0.0f;               // the widest filter, tangents
  double pixels = 0.0;               // of the picture, that what it lights may cover
  double importance = 0.0;           // of the light: candela times pixels
  TranslucentBounds translucent;
};

// How many views a light has, seen or not: 1 or 6.
[[nodiscard]] std::uint32_t view_count(const shading::GpuLight& light);

// The views that matter, light after light and face after face: those that see a caster, and light a part of what the
// viewer may see. Lights that cast no shadow have none, nor has the sun. translucent: do such casters count?
[[nodiscard]] std::vector<View> wanted_views(std::span<const shading::GpuLight> lights, const Viewer& viewer,
                                             const upload::CasterTable& casters, bool translucent);

// Texels a side: a power of two within the settings' largest.
[[nodiscard]] std::uint32_t wanted_size(const View& view, const Settings& settings);

// Tiles are never smaller: below it shadows are but spots, and borders eat the tile.
inline constexpr std::uint32_t kSmallestTile = 32;

// The side of the atlas, texels: a power of two.
[[nodiscard]] std::uint32_t atlas_side(const Settings& settings);

}  // namespace velarium::local_shadows
