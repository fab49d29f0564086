#include "passes/local_shadows/local_shadows.hpp"

#include <algorithm>

namespace velarium::local_shadows {
namespace {

using graph::Access;
using upload::CasterKind;

// A texel stores the depth at its middle, and bilinear comparisons reach a texel away on both axes: there the plane of
// the surface itself is nearer by up to both slopes, at most twice the steeper one. Reversed depth: away is less.
constexpr float kSlopeBias = -2.0f;

VkCullModeFlags culled(ShadowFaces faces) {
  return faces == ShadowFaces::back ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_NONE;
}

graph::Area area_of(const Tile& tile) {
  return {tile.x, tile.y, tile.size, tile.size};
}

void draw_map(const graph::Context& c, const upload::Tables& tables, const MapDraw& map, VkFormat format,
              VkCullModeFlags cull) {
  c.set_area(area_of(map.tile));
  const upload::CasterView view{
      .clip_from_world = map.clip_from_world, .cull = cull, .state = {.depth_format = format, .depth_bias = true}};
  for (const CasterKind kind : {CasterKind::opaque, CasterKind::cutout})
    upload::draw_casters(c.tools(), c.commands(), tables, upload::visible_casters(tables.casters, kind, map.planes),
                         kind, view);
}

void draw_translucency(const graph::Context& c, const upload::Tables& tables, const MapDraw& map, VkFormat depth) {
  c.set_area(area_of(map.tile));
  const upload::CasterView view{.clip_from_world = map.clip_from_world,
                                .state = upload::translucency_state(depth, false)};
  const auto draws = upload::visible_casters(tables.casters, CasterKind::translucent, map.planes);
  upload::draw_casters(c.tools(), c.commands(), tables, draws, CasterKind::translucent, view);
}

graph::GraphImage add_depth(graph::Graph& graph, const Inputs& in, graph::GraphImage atlas) {
  auto& pass = graph.pass("local_shadows");
  const auto drawn = pass.write(atlas, Access::depth_attachment);
  pass.run([in, drawn, cull = culled(in.settings.faces)](graph::Context& c) {
    const VkFormat format = c.image(drawn).desc().format;
    c.begin_rendering({.depth = drawn});
    // All before the first draw: a software driver finishes what it has at each clear.
    for (const MapDraw& map : in.state.draws) c.clear_depth(area_of(map.tile));
    vkCmdSetDepthBias(c.commands(), 0.0f, 0.0f, kSlopeBias);
    for (const MapDraw& map : in.state.draws) draw_map(c, in.tables, map, format, cull);
    c.end_rendering();
  });
  return drawn;
}

// Beside maps whose depths are drawn.
graph::GraphImage add_translucency(graph::Graph& graph, const Inputs& in, graph::GraphImage atlas,
                                   graph::GraphImage translucency) {
  auto& pass = graph.pass("local_translucency");
  pass.read(atlas, Access::depth_test);
  const auto drawn = pass.write(translucency, Access::color_attachment);
  pass.run([in, atlas, drawn](graph::Context& c) {
    const VkFormat format = c.image(atlas).desc().format;
    c.begin_rendering({.colors = {{drawn}}, .depth = atlas, .depth_writable = false});
    for (const MapDraw& map : in.state.draws)
      if (map.translucent) c.clear_color(area_of(map.tile), upload::kNoTranslucency);
    for (const MapDraw& map : in.state.draws)
      if (map.translucent) draw_translucency(c, in.tables, map, format);
    c.end_rendering();
  });
  return drawn;
}

std::uint32_t taps_of(const Inputs& in) {
  return upload::any_area_light(in.tables.lights) ? static_cast<std::uint32_t>(in.settings.taps) : 1;
}

}  // namespace

Reading add(graph::Graph& graph, const Inputs& in) {
  if (!in.state.atlas) return {};
  // What lies between the tiles is never read, so that a new image counts as initialised where nothing is drawn.
  Reading out{.atlas = graph.import("local_shadows.atlas", in.state.atlas, true),
              .views = graph.upload("local_shadows.views", in.state.views),
              .first_view = graph.upload("local_shadows.first_view", in.state.first_view),
              .taps = taps_of(in)};
  if (in.state.translucency) out.translucency = graph.import("local_translucency.atlas", in.state.translucency, true);
  if (!in.first || in.state.draws.empty()) return out;
  out.atlas = add_depth(graph, in, out.atlas);
  if (std::ranges::any_of(in.state.draws, &MapDraw::translucent))
    out.translucency = add_translucency(graph, in, out.atlas, out.translucency);
  return out;
}

}  // namespace velarium::local_shadows
