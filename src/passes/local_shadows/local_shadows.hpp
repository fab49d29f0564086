#pragma once

#include "graph/graph.hpp"
#include "passes/local_shadows/read.hpp"
#include "passes/local_shadows/state.hpp"

namespace velarium::local_shadows {

struct Inputs {
  const upload::Tables& tables;
  State& state;
  bool first = true;  // the first frame of a picture draws, the others read
  Settings settings;
};

[[nodiscard]] Reading add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::local_shadows
