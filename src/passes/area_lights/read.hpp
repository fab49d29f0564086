#pragma once

#include "graph/graph.hpp"
#include "passes/io.hpp"

namespace velarium::area_lights {

namespace io {
using namespace shading;
#include "passes/area_lights/area_lights_io.glsl"
}  // namespace io

// Area lights as lit points read them.
struct Reading {
  bool any = false;          // some light has a size, and is mirrored as round as it is
  graph::GraphBuffer table;  // io::AreaLights
};

inline void declare(graph::Pass&, const Reading&, graph::Access) {}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.buffer(io::AreaLightBuffer, in.table);
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kAreaLights, in.any);
}

}  // namespace velarium::area_lights
