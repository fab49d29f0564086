#pragma once

#include "graph/graph.hpp"
#include "passes/far_shadows/read.hpp"
#include "passes/far_shadows/state.hpp"

#include <array>

namespace velarium::far_shadows {

// Images of the frame that a map of moments is drawn and blurred through, as dumps name them.
inline constexpr std::array kSteps{"far_shadows.depth", "far_shadows_rows.moments"};

struct Inputs {
  const upload::Tables& tables;
  State& state;
  bool first = true;  // is this the first frame of the picture? The others read what it drew
  Settings settings;
};

// Draws the map, and blurs it where it is one of moments.
[[nodiscard]] Reading add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::far_shadows
