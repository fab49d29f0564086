#include "upload/host_images.hpp"

#include "core/jobs.hpp"
#include "gpu/barrier.hpp"
#include "upload/mips.hpp"
#include "upload/normal_mips.hpp"

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

void write_mips(std::span<const TexelRows> levels, const ImageSource& source) {
  if (source.filter == MipFilter::normals) return make_normal_mips(levels);
  for (std::size_t mip = 1; mip < levels.size(); ++mip)
    make_mip(levels[mip - 1], levels[mip], is_srgb(source.desc.format));
}

void write(const gpu::Image& image, const ImageSource& source) {
  std::vector<TexelRows> levels;
  for (std::uint32_t mip = 0; mip < source.desc.mips; ++mip) levels.push_back(rows_of(image, mip));
  const TexelRows& full = levels.front();
  const std::size_t row_bytes = kTexelBytes * full.width;
  for (std::uint32_t y = 0; y < full.height; ++y) {
    const auto row = source.texels.subspan(y * row_bytes, row_bytes);
    if (source.filter == MipFilter::normals)
      copy_without_alpha(row, full.first + y * full.pitch);
    else
      std::memcpy(full.first + y * full.pitch, row.data(), row_bytes);
  }
  write_mips(levels, source);
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
  parallel_for(sources.size(), [&](std::size_t i) { write(images[i], sources[i]); });

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
