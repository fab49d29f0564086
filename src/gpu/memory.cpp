#include "gpu/memory.hpp"

#include "core/assert.hpp"
#include "core/huge_pages.hpp"
#include "gpu/check.hpp"

#include <velarium/error.hpp>

#include <algorithm>

namespace velarium::gpu {
namespace {

// Large enough that a scene needs few blocks, small enough that a tiny picture wastes little.
constexpr VkDeviceSize kBlockSize = VkDeviceSize{32} << 20;

VkDeviceSize align_up(VkDeviceSize value, VkDeviceSize alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

}  // namespace

MemoryAllocator::MemoryAllocator(VkPhysicalDevice physical, VkDevice device) : device_(device) {
  vkGetPhysicalDeviceMemoryProperties(physical, &properties_);
  VkPhysicalDeviceProperties device_properties{};
  vkGetPhysicalDeviceProperties(physical, &device_properties);
  host_is_device_ = device_properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

MemoryAllocator::~MemoryAllocator() {
  for (const auto& block : blocks_)
    if (block.memory != VK_NULL_HANDLE) vkFreeMemory(device_, block.memory, nullptr);
}

Allocation MemoryAllocator::allocate(const VkMemoryRequirements& needs, MemoryUse use, bool linear) {
  const std::uint32_t type = memory_type(needs.memoryTypeBits, use);
  Allocation result;
  std::uint32_t index = 0;
  for (; index < blocks_.size(); ++index) {
    auto& block = blocks_[index];
    if (block.memory != VK_NULL_HANDLE && block.type == type && block.linear == linear && take(block, needs, result))
      break;
  }
  if (index == blocks_.size()) {
    // A resource above half a block gets memory of its own, which goes back as a whole.
    const VkDeviceSize size = needs.size > kBlockSize / 2 ? needs.size : kBlockSize;
    index = add_block(type, size, linear);
    const bool fits = take(blocks_[index], needs, result);
    VEL_ASSERT(fits);
    static_cast<void>(fits);
  }
  result.block = index;
  used_ += result.size;
  peak_ = std::max(peak_, used_);
  return result;
}

void MemoryAllocator::free(const Allocation& allocation) noexcept {
  if (allocation.memory == VK_NULL_HANDLE) return;
  auto& block = blocks_[allocation.block];
  used_ -= allocation.size;
  auto [range, inserted] = block.free_ranges.emplace(allocation.offset, allocation.size);
  static_cast<void>(inserted);
  if (const auto next = std::next(range);
      next != block.free_ranges.end() && range->first + range->second == next->first) {
    range->second += next->second;
    block.free_ranges.erase(next);
  }
  if (range != block.free_ranges.begin()) {
    if (const auto before = std::prev(range); before->first + before->second == range->first) {
      before->second += range->second;
      block.free_ranges.erase(range);
    }
  }
  release_if_empty(block);
}

void MemoryAllocator::release_if_empty(Block& block) noexcept {
  const bool empty = block.free_ranges.size() == 1 && block.free_ranges.begin()->second == block.size;
  if (!empty || block.size == kBlockSize) return;
  vkFreeMemory(device_, block.memory, nullptr);
  block = {};
}

bool MemoryAllocator::take(Block& block, const VkMemoryRequirements& needs, Allocation& out) {
  for (auto range = block.free_ranges.begin(); range != block.free_ranges.end(); ++range) {
    const auto [start, length] = *range;
    const VkDeviceSize offset = align_up(start, needs.alignment);
    if (offset + needs.size > start + length) continue;
    block.free_ranges.erase(range);
    if (offset > start) block.free_ranges.emplace(start, offset - start);
    const VkDeviceSize end = offset + needs.size;
    if (end < start + length) block.free_ranges.emplace(end, start + length - end);
    out = {block.memory, offset, needs.size, block.mapped != nullptr ? block.mapped + offset : nullptr, 0};
    return true;
  }
  return false;
}

std::uint32_t MemoryAllocator::add_block(std::uint32_t type, VkDeviceSize size, bool linear) {
  const VkMemoryAllocateInfo info{
      .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = size, .memoryTypeIndex = type};
  Block block{.size = size, .type = type, .linear = linear, .free_ranges = {{0, size}}};
  check(vkAllocateMemory(device_, &info, nullptr, &block.memory), "allocating device memory");
  const bool mappable = (properties_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0;
  if (mappable && (linear || host_is_device_)) {
    void* mapped = nullptr;
    check(vkMapMemory(device_, block.memory, 0, VK_WHOLE_SIZE, 0, &mapped), "mapping device memory");
    block.mapped = static_cast<std::byte*>(mapped);
    if (host_is_device_) prefer_huge_pages({block.mapped, size});
  }
  for (std::uint32_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].memory != VK_NULL_HANDLE) continue;
    blocks_[i] = std::move(block);
    return i;
  }
  blocks_.push_back(std::move(block));
  return static_cast<std::uint32_t>(blocks_.size() - 1);
}

std::uint32_t MemoryAllocator::memory_type(std::uint32_t allowed, MemoryUse use) const {
  constexpr VkMemoryPropertyFlags kHost = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  const VkMemoryPropertyFlags required = use == MemoryUse::device ? 0 : kHost;
  const VkMemoryPropertyFlags wished = use == MemoryUse::device     ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                                       : use == MemoryUse::readback ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                                                    : 0;
  for (const VkMemoryPropertyFlags flags : {required | wished, required}) {
    for (std::uint32_t i = 0; i < properties_.memoryTypeCount; ++i)
      if ((allowed >> i & 1u) != 0 && (properties_.memoryTypes[i].propertyFlags & flags) == flags) return i;
  }
  throw Error(ErrorCode::no_device, "the device has no memory type for this use");
}

}  // namespace velarium::gpu
