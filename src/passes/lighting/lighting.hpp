#pragma once

#include "passes/shading_inputs.hpp"

namespace velarium::lighting {

struct Inputs {
  passes::ShadingInputs shading;
  passes::GBuffer surface;
  graph::GraphImage hdr;    // emissive light
  graph::GraphImage lamps;  // light_volumes: what all lamps reflect; version 0: this pass asks lamps itself
};

struct Outputs {
  graph::GraphImage hdr;             // lit; premultiplied by the coverage in alpha
  graph::GraphBuffer forward_lists;  // bit masks in light order, tile after tile; version 0 where nothing needs them
};

[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::lighting
