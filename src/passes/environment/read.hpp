#pragma once

#include "graph/graph.hpp"
#include "passes/io.hpp"

namespace velarium::environment {

namespace io {
using namespace shading;
#include "passes/environment/environment_io.glsl"
}  // namespace io

// Distant light as lit points read it. Images outlive the frame; null where there is no environment.
struct Reading {
  const gpu::Image* background = nullptr;  // equirectangular
  const gpu::Image* lobes = nullptr;       // cube of pre-convolved levels
  const gpu::Image* irradiance = nullptr;  // cube of irradiance / pi
  const gpu::Image* brdf_table = nullptr;  // E0, E1 by (n.v, smoothness), of the model in use; always there
  graph::GraphBuffer table;                // io::Environment
  bool sh = false;                         // irradiance from the table's harmonics
  bool occlusion = true;                   // baked occlusion textures darken it
};

inline void declare(graph::Pass&, const Reading&, graph::Access) {}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.sampled(io::environment_lobes, in.lobes)
      .sampled(io::environment_brdf, in.brdf_table)
      .sampled(io::environment_irradiance, in.irradiance)
      .buffer(io::EnvironmentBuffer, in.table);
}

inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kEnvironment, in.lobes != nullptr).set(io::kDiffuseSh, in.sh).set(io::kOcclusion, in.occlusion);
}

}  // namespace velarium::environment
