#pragma once

// Barriers of synchronization2, spelled once: whose work must be over and visible, before whose work may begin.

#include "gpu/image.hpp"

namespace velarium::gpu {

// Stages of the pipeline, and what they do to memory.
struct Scope {
  VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
  VkAccessFlags2 access = VK_ACCESS_2_NONE;
};

inline constexpr Scope kAllWork{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
inline constexpr Scope kAllWrites{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT};
inline constexpr Scope kTransferRead{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
inline constexpr Scope kTransferWrite{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
inline constexpr Scope kHostRead{VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT};

struct Layouts {
  VkImageLayout before = VK_IMAGE_LAYOUT_UNDEFINED, after = VK_IMAGE_LAYOUT_UNDEFINED;
};

struct MipRange {
  std::uint32_t first = 0, count = VK_REMAINING_MIP_LEVELS;
  bool operator==(const MipRange&) const = default;
};

// All layers and aspects of these mips; the queue stays the same. `image.layout` is left to the caller.
[[nodiscard]] VkImageMemoryBarrier2 image_barrier(const Image& image, const Scope& before, const Scope& after,
                                                  const Layouts& layouts, const MipRange& mips = {});

// All memory.
[[nodiscard]] constexpr VkMemoryBarrier2 memory_barrier(const Scope& before, const Scope& after) {
  return {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
          .srcStageMask = before.stages,
          .srcAccessMask = before.access,
          .dstStageMask = after.stages,
          .dstAccessMask = after.access};
}

// One barrier by itself; several at once are cheaper in one vkCmdPipelineBarrier2.
void record(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier);
void record(VkCommandBuffer commands, const VkMemoryBarrier2& barrier);

}  // namespace velarium::gpu
