#pragma once

#include "passes/gbuffer/read.hpp"
#include "passes/illumination.hpp"

namespace velarium::light_volumes {

struct Inputs {
  passes::Illumination illumination;
  gbuffer::Reading gbuffer;
};

// Draws light after light over the opaque surfaces that it may reach. Returns their sum, rgba32f: rgb: radiance towards
// the eye, where a lit surface was drawn; elsewhere anything. Adds no pass where no light is to be seen: then version
// 0. Precondition: the device can blend 32-bit floats.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::light_volumes
