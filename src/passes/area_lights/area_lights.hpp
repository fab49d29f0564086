#pragma once

#include "passes/area_lights/read.hpp"
#include "upload/tables.hpp"

#include <velarium/settings.hpp>

namespace velarium::area_lights {

[[nodiscard]] Reading add(graph::Graph& graph, const upload::Tables& tables,
                          const Settings::lighting_settings& settings);

}  // namespace velarium::area_lights
