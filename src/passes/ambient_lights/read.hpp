#pragma once

#include "graph/graph.hpp"
#include "passes/io.hpp"

namespace velarium::ambient_lights {

namespace io {
using namespace shading;
#include "passes/ambient_lights/ambient_lights_io.glsl"
}  // namespace io

// Lights that multiply what surrounds a point, as lit points read them. Tables have version 0 where there are none.
struct Reading {
  std::uint32_t count = 0;
  graph::GraphBuffer lights;  // shading::GpuAmbientLight
  graph::GraphBuffer table;   // io::AmbientLights
};

inline void declare(graph::Pass&, const Reading&, graph::Access) {}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.buffer(io::AmbientLightBuffer, in.lights).buffer(io::AmbientLightsBuffer, in.table);
}
inline std::uint64_t loop_iterations(const Reading& in) {
  return in.count;
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kAmbientLights, in.count > 0);
}

}  // namespace velarium::ambient_lights
