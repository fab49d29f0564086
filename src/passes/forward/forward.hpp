#pragma once

#include "passes/shading_inputs.hpp"

namespace velarium::forward {

struct Inputs {
  passes::ShadingInputs shading;
  graph::GraphImage depth, hdr;
  graph::GraphBuffer forward_lists;  // version 0: the scene has no light
};

// Draws the BLEND surfaces over the picture, far to near. Adds no pass where there are none.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::forward
