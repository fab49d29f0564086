#pragma once

#include "gpu/vulkan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace velarium::gpu {

struct ReflectedBinding {
  std::uint32_t set = 0, binding = 0;
  VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
  std::uint32_t count = 1;  // array size
};

// What a shader module binds, read from its SPIR-V, so that no C++ repeats it.
struct Reflection {
  std::vector<ReflectedBinding> bindings;
  bool has_push_constants = false;
};

// Precondition: SPIR-V of our own build. Understands uniform and storage buffers, images with a sampler and without,
// samplers, storage images, and arrays of them.
[[nodiscard]] Reflection reflect(std::span<const std::uint32_t> spirv);

}  // namespace velarium::gpu
