#pragma once

#include "passes/sun_map.hpp"

#include <velarium/settings.hpp>

namespace velarium::sun_mask {

struct Inputs {
  const upload::SceneTables& scene;
  graph::GraphImage rt0, depth;  // shading/gbuffer.glsl
  graph::GraphImage cascades;    // of sun_shadows
  passes::FarSunMap far;         // of far_shadows
};

// A picture of one float: the share of the sun that is hidden, by what the maps hold or by contact shadows, 0 where the
// surface faces away from it. Precondition: there is a sun that casts shadows.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in, const Settings& settings);

}  // namespace velarium::sun_mask
