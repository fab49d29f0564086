#include "passes/contact_shadows/contact_shadows.hpp"

namespace velarium::contact_shadows {

Readings add(graph::Graph& graph, bool any_local_map, const Settings& settings) {
  const io::ContactShadows table{.longest = settings.length, .thickness = settings.thickness};
  Reading reading{.without_map = settings.without_map, .table = graph.upload("contact_shadows.table", table)};
  if (!settings.enabled) return {reading, reading};
  Readings readings{reading, reading};
  readings.sun.steps = static_cast<std::uint32_t>(settings.steps);
  if (any_local_map || settings.without_map) readings.local.steps = readings.sun.steps;
  return readings;
}

}  // namespace velarium::contact_shadows
