#pragma once

#include "graph/graph.hpp"

#include <velarium/settings.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace velarium::display {

struct Settings {
  Tonemap tonemap = Tonemap::neutral;
  int bits = 8;            // 8: values are rounded to k * 257; 16
  bool dither = true;      // of 8-bit pictures alone
  std::uint32_t seed = 0;  // of the dither
  // What lies behind the picture, sRGB-encoded, 0..1: the result is opaque. None: alpha stays, straight.
  std::optional<std::array<float, 3>> background;
};

struct Inputs {
  graph::GraphImage sum;        // rgba32f: the premultiplied light of all frames
  graph::GraphBuffer exposure;  // one float
  std::uint32_t frame_count = 1;
};

// Scene light to display values. Returns a readback buffer: four 16-bit values a pixel, R G B A, sRGB-encoded,
// rows from the top. At 8 bits each value is v8 * 257, so that v16 >> 8 is v8.
[[nodiscard]] graph::GraphBuffer add(graph::Graph& graph, const Inputs& in, const Settings& settings);

// The mean of the frames before exposure: four floats a pixel, premultiplied, in a readback buffer.
[[nodiscard]] graph::GraphBuffer linear_readback(graph::Graph& graph, graph::GraphImage sum, std::uint32_t frame_count);

}  // namespace velarium::display
