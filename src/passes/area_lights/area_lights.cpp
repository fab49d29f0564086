#include "passes/area_lights/area_lights.hpp"

namespace velarium::area_lights {

Reading add(graph::Graph& graph, const upload::Tables& tables, const Settings::lighting_settings& settings) {
  const io::AreaLights table{.min_highlight_alpha = settings.min_highlight_alpha};
  return {.any = settings.area_lights && upload::any_area_light(tables.lights),
          .table = graph.upload("area_lights.table", table)};
}

}  // namespace velarium::area_lights
