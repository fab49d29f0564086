#include "gpu/limits.hpp"

#include <fmt/core.h>

#include <array>

namespace velarium::gpu {

DeviceLimits device_limits(const VkPhysicalDeviceLimits& limits) {
  return {.samplers = limits.maxPerStageDescriptorSamplers,
          .sampled_images = limits.maxPerStageDescriptorSampledImages,
          .storage_images = limits.maxPerStageDescriptorStorageImages,
          .storage_buffers = limits.maxPerStageDescriptorStorageBuffers,
          .bound_sets = limits.maxBoundDescriptorSets,
          .push_constant_bytes = limits.maxPushConstantsSize};
}

std::string missing_limit(const DeviceLimits& limits) {
  struct Row {
    const char* what;
    std::uint32_t has, needs;
  };
  const auto& needs = kUsedLimits;
  const std::array rows{Row{"samplers a stage", limits.samplers, needs.samplers},
                        Row{"sampled images a stage", limits.sampled_images, needs.sampled_images},
                        Row{"storage images a stage", limits.storage_images, needs.storage_images},
                        Row{"storage buffers a stage", limits.storage_buffers, needs.storage_buffers},
                        Row{"bound descriptor sets", limits.bound_sets, needs.bound_sets},
                        Row{"bytes of push constants", limits.push_constant_bytes, needs.push_constant_bytes}};
  for (const Row& row : rows)
    if (row.has < row.needs) return fmt::format("it has {} {}, of which {} are needed", row.has, row.what, row.needs);
  return {};
}

}  // namespace velarium::gpu
