#pragma once

#include "gpu/vulkan.hpp"

namespace velarium::graph {

// How a pass uses a resource. Images and buffers share the list; the image layouts are for images alone.
enum class Access {
  compute_sample,    // sampled in a compute shader (images), or read as a uniform or storage buffer
  compute_storage,   // loaded and stored in a compute shader
  fragment_sample,   // sampled in a fragment shader, or read there or in the vertex shader as a buffer
  color_attachment,  // drawn to; blending and loading included
  depth_attachment,  // tested and written; stencil included
  depth_test,        // tested, not written, perhaps sampled at the same time
  transfer_read,
  transfer_write,
  host_read,  // read by the host after the frame
};

struct AccessInfo {
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 reads, writes;
  VkImageLayout layout;
  VkImageUsageFlags image_usage;
  VkBufferUsageFlags buffer_usage;
};

// `depth`: the image has a depth aspect, which is sampled in the layout in which it can be tested, too.
[[nodiscard]] AccessInfo access_info(Access access, bool depth);

}  // namespace velarium::graph
