#include "gpu/barrier.hpp"

namespace velarium::gpu {

VkImageMemoryBarrier2 image_barrier(const Image& image, const Scope& before, const Scope& after, const Layouts& layouts,
                                    const MipRange& mips) {
  return {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
          .srcStageMask = before.stages,
          .srcAccessMask = before.access,
          .dstStageMask = after.stages,
          .dstAccessMask = after.access,
          .oldLayout = layouts.before,
          .newLayout = layouts.after,
          .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
          .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
          .image = image.vk(),
          .subresourceRange = {aspects(image.desc().format), mips.first, mips.count, 0, VK_REMAINING_ARRAY_LAYERS}};
}

void record(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

void record(VkCommandBuffer commands, const VkMemoryBarrier2& barrier) {
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace velarium::gpu
