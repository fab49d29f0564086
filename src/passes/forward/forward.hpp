#pragma once

#include "graph/graph.hpp"
#include "upload/gpu_scene.hpp"

namespace velarium::forward {

struct Inputs {
  const upload::SceneTables& scene;
  const gpu::Image& environment;  // cube of pre-convolved levels
  const gpu::Image& irradiance;   // cube of irradiance / pi
  const gpu::Image& brdf_table;
  gpu::Specialization shading_constants;  // of upload/frame_lighting.glsl, kSharedConstants of them
  graph::GraphImage depth, hdr;
  graph::GraphBuffer forward_lists;  // version 0: the scene has no light
};

// Draws the BLEND surfaces over the picture, far to near. Adds no pass where there are none.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::forward
