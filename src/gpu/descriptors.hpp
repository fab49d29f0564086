#pragma once

#include "gpu/buffer.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/slot.hpp"

#include <variant>
#include <vector>

namespace velarium::gpu {

// What one descriptor set binds. A value: it names resources and owns none.
class Bindings {
 public:
  // With a sampler of its own, or without.
  Bindings& sampled(const Slot& slot, VkImageView view, VkSampler sampler,
                    VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  Bindings& storage(const Slot& slot, VkImageView view);
  Bindings& image(const Slot& slot, VkImageView view, VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  // All of a buffer, or `bytes` of it from `offset`.
  Bindings& buffer(const Slot& slot, const Buffer& buffer, VkDeviceSize offset = 0, VkDeviceSize bytes = VK_WHOLE_SIZE);

  struct Entry {
    std::uint32_t binding;
    std::variant<VkDescriptorImageInfo, VkDescriptorBufferInfo> info;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

// Hands out descriptor sets, all taken back at once by reset() or the end. Grows by whole pools. Submissions that may
// run at the same time have their sets from pools of their own.
class DescriptorAllocator {
 public:
  explicit DescriptorAllocator(Device& device) : device_(device) {}
  ~DescriptorAllocator();
  DescriptorAllocator(const DescriptorAllocator&) = delete;
  DescriptorAllocator& operator=(const DescriptorAllocator&) = delete;

  // Bindings that the pipeline's shaders do not use are left out.
  // Precondition: every binding that they do use is given.
  [[nodiscard]] VkDescriptorSet make(const Pipeline& pipeline, std::uint32_t set, const Bindings& bindings);
  // From here on sets come from the pools of this number, whose earlier sets are taken back.
  // Precondition: no submission that uses those is running.
  void reset(std::size_t pools = 0);

 private:
  [[nodiscard]] VkDescriptorSet allocate(VkDescriptorSetLayout layout);
  void add_pool();

  Device& device_;
  std::vector<std::vector<VkDescriptorPool>> parked_;  // of other submissions, by number
  std::vector<VkDescriptorPool> pools_;                // of the one that is recorded
  std::size_t number_ = 0, current_ = 0;
};

}  // namespace velarium::gpu
