#include "passes/local_shadows/plan.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace velarium::local_shadows {
namespace {

// Tangents at which the tile ends.
double tile_tangent(const View& view, const Tile& tile) {
  return static_cast<double>(
      shading::widened_tangent(static_cast<float>(view.half_tangent), view.kernel, static_cast<float>(tile.size)));
}

shading::ShadowView shadow_view(const View& view, const Tile& tile, std::uint32_t atlas_side) {
  const double side = atlas_side, size = tile.size, tangent = tile_tangent(view, tile);
  const double scale = 0.5 * size / (tangent * side);  // atlas coordinates a tangent
  const glm::dvec2 middle = (glm::dvec2(tile.x, tile.y) + 0.5 * size) / side;
  const bool translucent = view.translucent.nearest > 0.0;
  const glm::dvec2 reach(scale * static_cast<double>(view.kernel) + static_cast<double>(shading::kShadowBorder) / side);
  return {.right = glm::vec4(scale * view.axes[0], middle.x),
          .down = glm::vec4(scale * view.axes[1], middle.y),
          .forward = glm::vec4(view.axes[2], view.near),
          .tile = glm::vec4((0.5 * size - 0.5) / side, view.kernel, 2.0 * tangent / size,
                            translucent ? 1.0 / view.translucent.nearest : 0.0),
          .translucent = translucent ? glm::vec4(middle + scale * view.translucent.low - reach,
                                                 middle + scale * view.translucent.high + reach)
                                     : glm::vec4(0.0f)};
}

glm::mat4 clip_from_world(const View& view, const Tile& tile) {
  const double scale = 1.0 / tile_tangent(view, tile);
  const glm::dmat4 rows(glm::dvec4(scale * view.axes[0], -scale * glm::dot(view.axes[0], view.position)),
                        glm::dvec4(scale * view.axes[1], -scale * glm::dot(view.axes[1], view.position)),
                        glm::dvec4(0.0, 0.0, 0.0, view.near),
                        glm::dvec4(view.axes[2], -glm::dot(view.axes[2], view.position)));
  return glm::mat4(glm::transpose(rows));
}

MapDraw map_draw(const View& view, const Tile& tile, const glm::dvec3& origin) {
  MapDraw draw{
      .tile = tile, .clip_from_world = clip_from_world(view, tile), .translucent = view.translucent.nearest > 0.0};
  for (const auto& side : pyramid_solid(view.position + origin, view.axes, tile_tangent(view, tile), view.reach))
    draw.planes.push_back(side.plane);
  return draw;
}

std::vector<std::uint32_t> sizes_of(const std::vector<View>& views, const Settings& settings) {
  std::vector<WantedTile> wanted;
  wanted.reserve(views.size());
  for (const auto& view : views) wanted.push_back({view.light, wanted_size(view, settings), view.importance});
  return fitting_sizes(wanted, atlas_side(settings), kSmallestTile);
}

}  // namespace

std::vector<PlacedView> place_views(const std::vector<View>& views, const Settings& settings) {
  const auto sizes = sizes_of(views, settings);
  std::vector<std::size_t> order(views.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<PlacedView> placed(views.size());
  AtlasAllocator allocator(atlas_side(settings));
  for (const std::size_t i : order) {
    placed[i].view = views[i];
    if (sizes[i] > 0) placed[i].tile = allocator.allocate(sizes[i]);
  }
  return placed;
}

Plan make_plan(const std::vector<PlacedView>& placed, std::span<const shading::GpuLight> lights,
               const glm::dvec3& origin, std::uint32_t atlas_side) {
  Plan plan;
  plan.first_view.resize(lights.size());
  for (const auto& [view, tile, redraw] : placed) {
    if (!tile) continue;
    auto& first = plan.first_view[view.light];
    if (first == 0) {
      first = static_cast<std::uint32_t>(plan.views.size()) + 1;
      plan.views.resize(plan.views.size() + view_count(lights[view.light]));
    }
    plan.views[first - 1 + view.face] = shadow_view(view, *tile, atlas_side);
    if (redraw) plan.draws.push_back(map_draw(view, *tile, origin));
  }
  return plan;
}

}  // namespace velarium::local_shadows
