#pragma once

#include "graph/graph.hpp"

#include <vector>

namespace velarium::graph {

struct PlannedBarrier {
  std::uint32_t index = 0;      // of the image or buffer in the graph
  gpu::MipRange mips = {0, 1};  // images alone
  VkPipelineStageFlags2 src_stages = 0, dst_stages = 0;
  VkAccessFlags2 src_access = 0, dst_access = 0;
  VkImageLayout old_layout = VK_IMAGE_LAYOUT_UNDEFINED, new_layout = VK_IMAGE_LAYOUT_UNDEFINED;  // images alone
  bool operator==(const PlannedBarrier&) const = default;
};

// What must happen before one pass.
struct PlannedPass {
  std::vector<PlannedBarrier> images, buffers;
};

struct Plan {
  std::vector<PlannedPass> passes;
  // After the last pass: brings the mips of an image that are left in several layouts into one.
  std::vector<PlannedBarrier> closing;
  // In which each image is left; UNDEFINED where no pass uses it.
  std::vector<VkImageLayout> final_layouts;
};

// What the device does when the graph begins, with the images and buffers that the executor keeps from graph to graph.
enum class Before {
  finished,  // nothing: the host has waited
  running,   // the graph before may still use them
};

// The barriers of a graph, pass by pass. Needs no device.
// Throws Error(internal) for a pass that needs an image in two layouts, and for a history that no pass writes.
[[nodiscard]] Plan plan(const Graph& graph, Before before = Before::finished);

}  // namespace velarium::graph
