#pragma once

#include "graph/graph.hpp"

#include <velarium/settings.hpp>

#include <cstdint>

namespace velarium::exposure {

struct Inputs {
  graph::GraphImage sum;  // rgba32f: the premultiplied light of all frames
  std::uint32_t frame_count = 1;
};

struct Outputs {
  graph::GraphBuffer exposure;  // one float: what radiance is multiplied by
};

// The multiplier of the manual and ev100 modes. Precondition: the mode is one of them.
[[nodiscard]] float manual_exposure(const Settings::display_settings& settings);

// Puts the multiplier of any mode into one buffer, so that its reader need not know the mode.
[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in, const Settings::display_settings& settings);

}  // namespace velarium::exposure
