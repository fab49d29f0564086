#pragma once

#include "graph/graph.hpp"
#include "passes/sun_shadows/read.hpp"
#include "passes/sun_shadows/state.hpp"

namespace velarium::sun_shadows {

struct Inputs {
  const upload::Tables& tables;
  State& state;
  bool first = true;  // is this the first frame of the picture? The others read what it drew
  Settings settings;
};

// Draws the maps.
[[nodiscard]] Reading add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::sun_shadows
