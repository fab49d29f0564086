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

// What smaller mips are made of.
enum class MipFilter {
  mean,    // each from the one before, by a linear-light 2x2 filter
  normals  // normal_mips.hpp; for one layer of 8-bit UNORM RGBA, whose alpha is replaced
};

// An image on the device, ready to be sampled, its first mip from `texels` (tightly packed rows), the further ones that
// `desc.mips` asks for by the filter.
struct ImageSource {
  gpu::ImageDesc desc;
  std::span<const std::byte> texels;
  MipFilter filter = MipFilter::mean;
};

inline constexpr gpu::Scope kSampledByShaders{
    VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
    VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};

// Uploads in batches of bounded staging memory, and lets the device make the mips.
[[nodiscard]] std::vector<gpu::Image> make_staged_images(gpu::Device& device, std::span<const ImageSource> sources);

// Where the device is the host, writes in place; elsewhere by make_staged_images().
[[nodiscard]] std::vector<gpu::Image> make_images(gpu::Device& device, std::span<const ImageSource> sources);

}  // namespace velarium::upload
