#include "passes/frame_scene.hpp"

namespace velarium::passes {

FrameScene frame_scene(graph::Graph& graph, const upload::Tables& tables, const upload::View& view,
                       const upload::FrameSample& sample) {
  const auto frame = upload::frame_uniforms(tables, view, sample);
  return {tables, view, frame, graph.upload("frame.uniforms", frame),
          graph.upload("lights.ranges", tables.light_ranges)};
}

}  // namespace velarium::passes
