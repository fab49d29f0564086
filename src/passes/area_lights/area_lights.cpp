#include "passes/area_lights/area_lights.hpp"

namespace velarium::area_lights {

Reading add(graph::Graph& graph, const upload::Tables& tables, const Settings::lighting_settings& settings) {
  const io::AreaLights table{.min_highlight_alpha = settings.min_highlight_alpha};
  return {.sphere_highlights = settings.sphere_highlights && upload::any_sized(tables.lights),
          .table = graph.upload("area_lights.table", table)};
}

}  // namespace velarium::area_lights
