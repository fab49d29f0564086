#pragma once

#include "graph/graph.hpp"
#include "upload/gpu_scene.hpp"

namespace velarium::gbuffer {

struct Inputs {
  const upload::SceneTables& scene;
  const gpu::Image& normal_lengths;  // best-fit normal table, R8
  std::uint32_t width = 0, height = 0;
};

// Ryse's layout: shading/gbuffer.glsl.
struct Outputs {
  graph::GraphImage rt0, rt1, rt2;
  graph::GraphImage depth;  // D32F reversed-Z, and the material class in the stencil
  graph::GraphImage hdr;    // rgba16f: emissive light, and coverage in alpha
};

[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::gbuffer
