#pragma once

#include "gpu/barrier.hpp"
#include "gpu/buffer.hpp"

#include <span>
#include <vector>

namespace velarium::upload {

// A buffer on the device with these bytes.
[[nodiscard]] gpu::Buffer make_buffer(gpu::Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage);

template <class T>
[[nodiscard]] gpu::Buffer make_buffer(gpu::Device& device, const std::vector<T>& values, VkBufferUsageFlags usage) {
  return make_buffer(device, std::as_bytes(std::span(values)), usage);
}

// An image on the device, ready to be sampled, its first mip from `texels` (tightly packed rows) and every further one
// from the one before by a linear-light 2x2 filter where `desc.mips` asks for it.
struct ImageSource {
  gpu::ImageDesc desc;
  std::span<const std::byte> texels;
};

inline constexpr gpu::Scope kSampledByShaders{
    VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
    VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};

// Where the device is the host, writes in place; elsewhere uploads in batches of bounded staging memory.
[[nodiscard]] std::vector<gpu::Image> make_images(gpu::Device& device, std::span<const ImageSource> sources);

}  // namespace velarium::upload
