#include "gpu/buffer.hpp"

#include "core/assert.hpp"
#include "gpu/check.hpp"

#include <algorithm>
#include <utility>

namespace velarium::gpu {

Buffer::Buffer(Device& device, VkDeviceSize size, VkBufferUsageFlags usage, MemoryUse use)
    : device_(&device), size_(std::max<VkDeviceSize>(size, 4)) {
  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size_, .usage = usage};
  check(vkCreateBuffer(device.vk(), &info, nullptr, &buffer_), "vkCreateBuffer");
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device.vk(), buffer_, &needs);
  allocation_ = device.memory().allocate(needs, use, true);
  check(vkBindBufferMemory(device.vk(), buffer_, allocation_.memory, allocation_.offset), "vkBindBufferMemory");
}

Buffer::~Buffer() {
  if (buffer_ == VK_NULL_HANDLE) return;
  vkDestroyBuffer(device_->vk(), buffer_, nullptr);
  device_->memory().free(allocation_);
}

Buffer::Buffer(Buffer&& other) noexcept
    : device_(other.device_),
      buffer_(std::exchange(other.buffer_, VK_NULL_HANDLE)),
      size_(std::exchange(other.size_, 0)),
      allocation_(std::exchange(other.allocation_, {})) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  Buffer moved(std::move(other));
  std::swap(device_, moved.device_);
  std::swap(buffer_, moved.buffer_);
  std::swap(size_, moved.size_);
  std::swap(allocation_, moved.allocation_);
  return *this;
}

std::span<std::byte> Buffer::mapped() const {
  VEL_ASSERT(allocation_.mapped != nullptr);
  return {allocation_.mapped, static_cast<std::size_t>(size_)};
}

}  // namespace velarium::gpu
