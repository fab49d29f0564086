#pragma once

#include "gpu/device.hpp"

#include <cstddef>
#include <span>

namespace velarium::gpu {

// A buffer with its memory. Moves, never copies.
class Buffer {
 public:
  Buffer() = default;
  // `size` 0 makes a buffer of 4 bytes, so that an empty table can still be bound.
  Buffer(Device& device, VkDeviceSize size, VkBufferUsageFlags usage, MemoryUse use);
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;

  [[nodiscard]] VkBuffer vk() const { return buffer_; }
  [[nodiscard]] VkDeviceSize size() const { return size_; }
  [[nodiscard]] explicit operator bool() const { return buffer_ != VK_NULL_HANDLE; }

  // Mapped bytes. Precondition: made for upload or readback.
  [[nodiscard]] std::span<std::byte> mapped() const;
  template <class T>
  [[nodiscard]] std::span<T> mapped_as() const {
    return {reinterpret_cast<T*>(mapped().data()), mapped().size() / sizeof(T)};
  }

 private:
  Device* device_ = nullptr;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceSize size_ = 0;
  Allocation allocation_;
};

}  // namespace velarium::gpu
