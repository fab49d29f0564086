#pragma once

#include "passes/frame_scene.hpp"
#include "passes/gbuffer/read.hpp"

namespace velarium::gbuffer {

struct Inputs {
  passes::FrameScene scene;
  const gpu::Image& normal_lengths;  // best-fit normal table, R8
  bool baked_normal_spread = true;   // mips of normal maps widen lobes
};

struct Outputs {
  Reading gbuffer;        // depth: D32F reversed-Z, and the material class in the stencil
  graph::GraphImage hdr;  // rgba16f: emissive light, and coverage in alpha
};

[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::gbuffer
