#pragma once

#include "graph/graph.hpp"

#include <vector>

namespace velarium::graph {

struct PlannedBarrier {
  std::uint32_t index = 0;  // of the image or buffer in the graph
  VkPipelineStageFlags2 src_stages = 0, dst_stages = 0;
  VkAccessFlags2 src_access = 0, dst_access = 0;
  VkImageLayout old_layout = VK_IMAGE_LAYOUT_UNDEFINED, new_layout = VK_IMAGE_LAYOUT_UNDEFINED;  // images alone
};

// What must happen before one pass.
struct PlannedPass {
  std::vector<PlannedBarrier> images, buffers;
};

// The barriers of a graph, pass by pass. Needs no device.
[[nodiscard]] std::vector<PlannedPass> plan(const Graph& graph);

}  // namespace velarium::graph
