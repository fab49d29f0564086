#pragma once

#include "gpu/vulkan.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace velarium::gpu {

enum class MemoryUse {
  device,    // fast for the device
  upload,    // mapped, written once by the host
  readback,  // mapped, cached where possible, read by the host
};

struct Allocation {
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize offset = 0, size = 0;
  std::byte* mapped = nullptr;  // this allocation's first byte; null for device memory that cannot be mapped
  std::uint32_t block = 0;      // where it came from
};

// Sub-allocates device memory from blocks, first fit, merging what is freed. Linear (buffers) and tiled (images)
// resources never share a block, so bufferImageGranularity plays no part. Not thread-safe.
class MemoryAllocator {
 public:
  MemoryAllocator(VkPhysicalDevice physical, VkDevice device);
  ~MemoryAllocator();
  MemoryAllocator(const MemoryAllocator&) = delete;
  MemoryAllocator& operator=(const MemoryAllocator&) = delete;

  // Throws Error(temporary) where memory runs out.
  [[nodiscard]] Allocation allocate(const VkMemoryRequirements& needs, MemoryUse use, bool linear);
  void free(const Allocation& allocation) noexcept;

  [[nodiscard]] std::uint64_t peak_bytes() const { return peak_; }

 private:
  struct Block {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize size = 0;
    std::uint32_t type = 0;
    bool linear = false;
    std::byte* mapped = nullptr;
    std::map<VkDeviceSize, VkDeviceSize> free_ranges;  // offset -> size
  };
  [[nodiscard]] std::uint32_t memory_type(std::uint32_t allowed, MemoryUse use) const;
  std::uint32_t add_block(std::uint32_t type, VkDeviceSize size, bool linear);
  static bool take(Block& block, const VkMemoryRequirements& needs, Allocation& out);
  void release_if_empty(Block& block) noexcept;

  VkDevice device_;
  VkPhysicalDeviceMemoryProperties properties_{};
  bool host_is_device_ = false;  // a CPU driver
  std::vector<Block> blocks_;    // an emptied large block keeps its place with a null memory
  std::uint64_t used_ = 0, peak_ = 0;
};

}  // namespace velarium::gpu
