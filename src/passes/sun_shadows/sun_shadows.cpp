#include "passes/sun_shadows/sun_shadows.hpp"

namespace velarium::sun_shadows {
namespace {

using graph::Access;
using upload::CasterKind;

// Beside maps whose depths are drawn.
graph::GraphImage add_translucency(graph::Graph& graph, const Inputs& in, graph::GraphImage depths,
                                   graph::GraphImage translucency) {
  auto& pass = graph.pass("sun_translucency");
  pass.read(depths, Access::depth_test);
  const auto drawn = pass.write(translucency, Access::color_attachment);
  pass.run([in, depths, drawn](graph::Context& c) {
    const auto& maps = in.state.maps();
    const auto& size = c.image(drawn).desc();
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
      if (!in.state.is_stale(i) || !in.state.is_translucent(i)) continue;
      c.begin_rendering({.colors = {{drawn}}, .depth = depths, .depth_writable = false, .layer = i});
      c.clear_color({0, 0, size.width, size.height}, upload::kNoTranslucency);
      const upload::CasterView view{.clip_from_world = clip_from_world(maps[i], in.tables.origin),
                                    .state = upload::translucency_state(c.image(depths).desc().format, true)};
      upload::draw_casters(c.tools(), c.commands(), in.tables,
                           upload::visible_casters(in.tables.casters, CasterKind::translucent, caster_planes(maps[i])),
                           CasterKind::translucent, view);
      c.end_rendering();
    }
  });
  return drawn;
}

graph::GraphImage add_depths(graph::Graph& graph, const Inputs& in, graph::GraphImage depths) {
  auto& pass = graph.pass("sun_shadows");
  const auto drawn = pass.write(depths, Access::depth_attachment);
  pass.run([in, drawn](graph::Context& c) {
    const auto& maps = in.state.maps();
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
      if (!in.state.is_stale(i)) continue;
      c.begin_rendering({.depth = drawn, .clear_depth = true, .layer = i});
      // Away from the sun, which is towards 0: depth is reversed.
      vkCmdSetDepthBias(c.commands(), 0.0f, 0.0f, -in.settings.slope_bias);
      passes::draw_sun_map(c, in.tables, maps[i], {.depth_format = c.image(drawn).desc().format});
      c.end_rendering();
    }
  });
  return drawn;
}

}  // namespace

Reading add(graph::Graph& graph, const Inputs& in) {
  if (in.state.empty()) return {};
  // Layers that are not drawn hold what was drawn before.
  Reading out{.depths = graph.import("sun_shadows.cascades", in.state.depths(), true),
              .table = graph.upload("sun_shadows.table", in.state.table()),
              .taps = static_cast<std::uint32_t>(in.settings.taps)};
  if (in.state.translucency())
    out.translucency = graph.import("sun_translucency.cascades", in.state.translucency(), true);
  if (!in.first) return out;
  out.depths = add_depths(graph, in, out.depths);
  if (in.state.translucency()) out.translucency = add_translucency(graph, in, out.depths, out.translucency);
  return out;
}

}  // namespace velarium::sun_shadows
