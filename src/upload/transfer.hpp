#pragma once

#include "gpu/buffer.hpp"
#include "gpu/image.hpp"

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

// Uploads in batches of bounded staging memory.
[[nodiscard]] std::vector<gpu::Image> make_images(gpu::Device& device, std::span<const ImageSource> sources);

}  // namespace velarium::upload
