#pragma once

#include "graph/graph.hpp"
#include "passes/far_shadows/far_shadows.hpp"
#include "passes/local_shadows/local_shadows.hpp"
#include "passes/shading_inputs.hpp"
#include "passes/sun_shadows/sun_shadows.hpp"

#include <velarium/settings.hpp>

#include <array>
#include <optional>

namespace velarium::frame {

// What one frame is made from. Everything outlives the frame.
struct FrameInputs {
  const upload::SceneTables& scene;
  const passes::Environment& environment;
  const gpu::Image& normal_lengths;
  const gpu::Image& no_map;  // of depth, where a map is missing
  local_shadows::Maps& local_shadows;
  sun_shadows::Maps& sun_maps;
  far_shadows::Map& far_map;
  gpu::Image& sum;    // rgba32f: of the frames of this picture so far
  bool first = true;  // does this frame start the sum?
  std::uint32_t width = 0, height = 0;
  const Settings& settings;
};

// One jittered frame, added to the sum. Returns the sum.
graph::GraphImage add_frame(graph::Graph& graph, const FrameInputs& in);

// What a finished sum becomes.
struct DisplayInputs {
  gpu::Image& sum;
  std::uint32_t frames = 1;
  const Settings& settings;
  std::optional<std::array<float, 3>> background;  // a colour behind the picture, display values
  bool want_linear = false, want_display = true;
};

struct DisplayOutputs {
  graph::GraphBuffer linear, display;  // read back; version 0 where not wanted
};

DisplayOutputs add_display(graph::Graph& graph, const DisplayInputs& in);

}  // namespace velarium::frame
