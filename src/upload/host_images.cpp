#include "upload/host_images.hpp"

#include "core/jobs.hpp"
#include "gpu/barrier.hpp"
#include "upload/mips.hpp"

#include <algorithm>
#include <cstring>

namespace velarium::upload {
namespace {

constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_SAMPLED_BIT;
constexpr std::size_t kTexelBytes = 4;

bool is_srgb(VkFormat format) {
  return format == VK_FORMAT_R8G8B8A8_SRGB;
}

TexelRows rows_of(const gpu::Image& image, std::uint32_t mip) {
  const auto [first, pitch] = image.mapped_rows(mip);
  const auto& desc = image.desc();
  return {first, pitch, std::max(desc.width >> mip, 1u), std::max(desc.height >> mip, 1u)};
}

void write(const gpu::Image& image, std::span<const std::byte> texels) {
  TexelRows level = rows_of(image, 0);
  const std::size_t row_bytes = kTexelBytes * level.width;
  for (std::uint32_t y = 0; y < level.height; ++y)
    std::memcpy(level.first + y * level.pitch, texels.data() + y * row_bytes, row_bytes);
  for (std::uint32_t mip = 1; mip < image.desc().mips; ++mip) {
    const TexelRows next = rows_of(image, mip);
    make_mip(level, next, is_srgb(image.desc().format));
    level = next;
  }
}

}  // namespace

bool host_can_write(const gpu::Device& device, const gpu::ImageDesc& desc) {
  const bool rgba8 = desc.format == VK_FORMAT_R8G8B8A8_UNORM || is_srgb(desc.format);
  return rgba8 && desc.layers == 1 && device.caps().host_is_device && gpu::can_be_linear(device, desc, kUsage);
}

std::vector<gpu::Image> make_host_images(gpu::Device& device, std::span<const ImageSource> sources) {
  std::vector<gpu::Image> images;
  images.reserve(sources.size());
  for (const auto& source : sources) images.emplace_back(device, source.desc, kUsage, gpu::Tiling::linear);
  parallel_for(sources.size(), [&](std::size_t i) { write(images[i], sources[i].texels); });

  constexpr gpu::Scope kHostWrite{VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_WRITE_BIT};
  const VkCommandBuffer commands = device.begin();
  for (auto& image : images) {
    constexpr VkImageLayout kSampled = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    gpu::record(commands, gpu::image_barrier(image, kHostWrite, kSampledByShaders, {image.layout, kSampled}));
    image.layout = kSampled;
  }
  device.submit_and_wait(commands);
  return images;
}

}  // namespace velarium::upload
