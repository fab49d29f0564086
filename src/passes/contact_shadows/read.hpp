#pragma once

#include "graph/graph.hpp"
#include "passes/io.hpp"

namespace velarium::contact_shadows {

namespace io {
using namespace shading;
#include "passes/contact_shadows/contact_shadows_io.glsl"
}  // namespace io

// Contact shadows as passes that march through the depth buffer read them.
struct Reading {
  std::uint32_t steps = 0;   // most samples a ray takes; 0: there are no contact shadows
  bool without_map = false;  // of lights that have no map, too
  graph::GraphBuffer table;  // io::ContactShadows
};

inline void bind(graph::SetWriter& set, const Reading& in) {
  set.buffer(io::ContactShadowBuffer, in.table);
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kContactSteps, in.steps).set(io::kContactWithoutMap, in.without_map);
}

}  // namespace velarium::contact_shadows
