#pragma once

#include "passes/ambient_lights/read.hpp"
#include "upload/view.hpp"

#include <velarium/settings.hpp>

#include <vector>

namespace velarium::ambient_lights {

using Settings = velarium::Settings::ambient_lights_settings;

// Those whose volumes the view may see, in the scene's order, relative to the origin of the tables.
[[nodiscard]] std::vector<shading::GpuAmbientLight> lights_in_view(const upload::Tables& tables,
                                                                   const upload::ViewMatrices& view);

[[nodiscard]] Reading add(graph::Graph& graph, const upload::Tables& tables, const upload::ViewMatrices& view,
                          const Settings& settings);

}  // namespace velarium::ambient_lights
