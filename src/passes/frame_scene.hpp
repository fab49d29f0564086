#pragma once

#include "graph/graph.hpp"
#include "upload/view.hpp"

namespace velarium::passes {

// What a frame shows, and from where: every pass over geometry or pixels of a view has it. Everything that it refers to
// outlives the frame.
struct FrameScene {
  const upload::Tables& tables;
  const upload::View& view;
  upload::FrameUniforms frame{};
  graph::GraphBuffer frame_buffer;  // the same, upload/frame_io.glsl
  graph::GraphBuffer light_ranges;  // upload/lights_io.glsl
};

// Precondition: `sample` is of the view's picture.
[[nodiscard]] FrameScene frame_scene(graph::Graph& graph, const upload::Tables& tables, const upload::View& view,
                                     const upload::FrameSample& sample);

}  // namespace velarium::passes
