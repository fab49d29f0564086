#pragma once

#include "bake/environment.hpp"
#include "frame/state.hpp"
#include "graph/executor.hpp"
#include "graph/graph.hpp"

#include <velarium/engine.hpp>
#include <velarium/settings.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace velarium::frame {

// What a picture is made with, once its maps are planned.
struct Prepared {
  Settings settings;               // with maps as large as shadows.memory allows
  std::vector<std::string> notes;  // decisions a user should hear of
};

// Plans what the frames of a picture share, before the first of them: which maps, how large, which are drawn.
[[nodiscard]] Prepared prepare(State& state, gpu::Device& device, const upload::Tables& tables,
                               const upload::View& view, const Settings& settings);

// Device memory of the maps that a picture holds, as dumps name them.
// images: those that the executor keeps.
[[nodiscard]] std::vector<MapMemory> shadow_maps(const State& state, std::span<const graph::KeptImage> images);

// The frame before, for techniques that look back: what it showed, and from where. Of a picture's first frame that is
// the last frame of the picture before; where there is none, the picture's own, as if all had stood still.
struct FrameBefore {
  const upload::Tables* tables = nullptr;
  const upload::View* view = nullptr;
  upload::FrameSample sample;
};

// What one frame is made from. Everything outlives the frame.
struct FrameInputs {
  const upload::Tables& tables;
  const upload::View& view;
  State& state;
  const bake::Environment* environment = nullptr;  // null: none
  const gpu::Image& brdf_table;                    // of settings.lighting.model
  const gpu::Image& normal_lengths;
  gpu::Image& sum;    // rgba32f: of the frames of this picture so far
  bool first = true;  // does this frame start the sum?
  upload::FrameSample sample;
  FrameBefore before;
  Background background = Background::environment;
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
