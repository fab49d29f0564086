#pragma once

#include "graph/graph.hpp"

namespace velarium::accumulate {

struct Inputs {
  graph::GraphImage hdr;  // rgba16f, premultiplied: this frame's light
  graph::GraphImage sum;  // rgba32f of the same size, imported: it is kept between frames
  bool first = false;     // the first frame replaces whatever `sum` holds
};

// Adds this frame to the sum. Returns the sum's next version.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::accumulate
