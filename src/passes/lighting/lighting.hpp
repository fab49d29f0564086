#pragma once

#include "passes/shading_inputs.hpp"

namespace velarium::lighting {

struct Inputs {
  passes::ShadingInputs shading;
  passes::GBuffer surface;
  graph::GraphImage hdr;  // emissive light
};

struct Outputs {
  graph::GraphImage hdr;             // lit; premultiplied by the coverage in alpha
  graph::GraphBuffer forward_lists;  // bit masks in light order, tile after tile; version 0 where nothing needs them
};

[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::lighting
