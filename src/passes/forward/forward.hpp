#pragma once

#include "passes/illumination.hpp"

namespace velarium::forward {

struct Inputs {
  passes::Illumination illumination;  // without the mask of the sun, which knows opaque surfaces alone
  bool baked_normal_spread = true;    // mips of normal maps widen lobes
  graph::GraphImage depth, hdr;
  graph::GraphBuffer forward_lists;  // version 0: the scene has no light
};

// Draws the BLEND surfaces over the picture, far to near. Adds no pass where there are none.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::forward
