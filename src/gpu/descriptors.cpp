#include "gpu/descriptors.hpp"

#include "gpu/check.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace velarium::gpu {
namespace {

// A pool serves some hundred sets of a handful of bindings: more than a frame of a small scene needs.
constexpr std::uint32_t kSetsPerPool = 256;

}  // namespace

Bindings& Bindings::sampled(const Slot& slot, VkImageView view, VkSampler sampler, VkImageLayout layout) {
  entries_.push_back({slot.binding, VkDescriptorImageInfo{sampler, view, layout}});
  return *this;
}

Bindings& Bindings::image(const Slot& slot, VkImageView view, VkImageLayout layout) {
  return sampled(slot, view, VK_NULL_HANDLE, layout);
}

Bindings& Bindings::storage(const Slot& slot, VkImageView view) {
  entries_.push_back({slot.binding, VkDescriptorImageInfo{VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL}});
  return *this;
}

Bindings& Bindings::buffer(const Slot& slot, const Buffer& buffer, VkDeviceSize offset, VkDeviceSize bytes) {
  entries_.push_back({slot.binding, VkDescriptorBufferInfo{buffer.vk(), offset, bytes}});
  return *this;
}

DescriptorAllocator::~DescriptorAllocator() {
  parked_.push_back(std::move(pools_));
  for (const auto& pools : parked_)
    for (const auto pool : pools) vkDestroyDescriptorPool(device_.vk(), pool, nullptr);
}

void DescriptorAllocator::reset(std::size_t pools) {
  parked_.resize(std::max({parked_.size(), pools + 1, number_ + 1}));
  parked_[number_].swap(pools_);
  pools_.swap(parked_[pools]);
  number_ = pools;
  for (const auto pool : pools_) check(vkResetDescriptorPool(device_.vk(), pool, 0), "vkResetDescriptorPool");
  current_ = 0;
}

VkDescriptorSet DescriptorAllocator::make(const Pipeline& pipeline, std::uint32_t set, const Bindings& bindings) {
  const VkDescriptorSet result = allocate(pipeline.set_layout(set));
  std::vector<VkWriteDescriptorSet> writes;
  for (const auto& entry : bindings.entries()) {
    const auto type = pipeline.binding_type(set, entry.binding);
    if (!type) continue;
    writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                      .dstSet = result,
                      .dstBinding = entry.binding,
                      .descriptorCount = 1,
                      .descriptorType = *type,
                      .pImageInfo = std::get_if<VkDescriptorImageInfo>(&entry.info),
                      .pBufferInfo = std::get_if<VkDescriptorBufferInfo>(&entry.info)});
  }
  vkUpdateDescriptorSets(device_.vk(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
  return result;
}

VkDescriptorSet DescriptorAllocator::allocate(VkDescriptorSetLayout layout) {
  for (;; ++current_) {
    const bool fresh = current_ == pools_.size();
    if (fresh) add_pool();
    const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                           .descriptorPool = pools_[current_],
                                           .descriptorSetCount = 1,
                                           .pSetLayouts = &layout};
    VkDescriptorSet set = VK_NULL_HANDLE;
    const VkResult result = vkAllocateDescriptorSets(device_.vk(), &info, &set);
    if (result == VK_SUCCESS) return set;
    const bool pool_is_full = result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
    if (!pool_is_full || fresh) check(result, "vkAllocateDescriptorSets");
  }
}

void DescriptorAllocator::add_pool() {
  const std::array sizes{VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 8 * kSetsPerPool},
                         VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 8 * kSetsPerPool},
                         VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, kSetsPerPool},
                         VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 4 * kSetsPerPool},
                         VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, kSetsPerPool}};
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = kSetsPerPool,
                                        .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                        .pPoolSizes = sizes.data()};
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device_.vk(), &info, nullptr, &pool), "vkCreateDescriptorPool");
  pools_.push_back(pool);
}

}  // namespace velarium::gpu
