#pragma once

#include "gpu/samplers.hpp"

namespace velarium::gpu {

// Descriptor set 3 of every pipeline: the samplers of gpu/samplers.glsl, written once.
class SharedSamplers {
 public:
  static constexpr std::uint32_t kSet = 3;
  static constexpr std::size_t kCount = 4;

  SharedSamplers(Device& device, SamplerCache& samplers);
  ~SharedSamplers();
  SharedSamplers(const SharedSamplers&) = delete;
  SharedSamplers& operator=(const SharedSamplers&) = delete;

  [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_; }
  [[nodiscard]] VkDescriptorSet set() const { return set_; }

 private:
  Device& device_;
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace velarium::gpu
