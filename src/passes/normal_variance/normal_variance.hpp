#pragma once

#include "graph/graph.hpp"
#include "upload/gpu_scene.hpp"

#include <velarium/settings.hpp>

namespace velarium::normal_variance {

using Settings = velarium::Settings::specular_aa_settings;

struct Inputs {
  const upload::SceneTables& scene;
  graph::GraphImage rt0, rt2, depth;  // of the G-buffer
};

// Widens the lobes of smooth surfaces whose normals differ from pixel to pixel. Returns rt2 with the smoothness and the
// luma of f0 that are left; adds no pass where settings.screen is off.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in, const Settings& settings);

}  // namespace velarium::normal_variance
