#include "upload/transfer.hpp"

#include "gpu/barrier.hpp"
#include "upload/host_images.hpp"
#include "upload/normal_mips.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

namespace velarium::upload {
namespace {

// Staging memory of one batch. A single larger image makes a batch of its own.
constexpr VkDeviceSize kBatchBytes = VkDeviceSize{64} << 20;

// Enough for every texel size that we upload (16 bytes), as vkCmdCopyBufferToImage wants offsets aligned to it.
constexpr VkDeviceSize kCopyAlignment = 16;

constexpr VkImageUsageFlags kUsage =
    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

VkOffset3D mip_corner(const gpu::ImageDesc& desc, std::uint32_t mip) {
  return {static_cast<std::int32_t>(std::max(desc.width >> mip, 1u)),
          static_cast<std::int32_t>(std::max(desc.height >> mip, 1u)), 1};
}

void blit_mip(VkCommandBuffer commands, const gpu::Image& image, std::uint32_t mip) {
  const auto& desc = image.desc();
  const VkImageBlit2 region{.sType = VK_STRUCTURE_TYPE_IMAGE_BLIT_2,
                            .srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, desc.layers},
                            .srcOffsets = {{0, 0, 0}, mip_corner(desc, mip - 1)},
                            .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, desc.layers},
                            .dstOffsets = {{0, 0, 0}, mip_corner(desc, mip)}};
  const VkBlitImageInfo2 blit{.sType = VK_STRUCTURE_TYPE_BLIT_IMAGE_INFO_2,
                              .srcImage = image.vk(),
                              .srcImageLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                              .dstImage = image.vk(),
                              .dstImageLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                              .regionCount = 1,
                              .pRegions = &region,
                              .filter = VK_FILTER_LINEAR};
  vkCmdBlitImage2(commands, &blit);
}

constexpr VkImageLayout kSampled = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;

void copy_level_0(VkCommandBuffer commands, const gpu::Image& image, VkBuffer staging, VkDeviceSize offset) {
  constexpr gpu::Scope kFresh{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE};
  constexpr VkImageLayout kDst = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  gpu::record(commands, gpu::image_barrier(image, kFresh, gpu::kTransferWrite, {VK_IMAGE_LAYOUT_UNDEFINED, kDst}));
  const auto& desc = image.desc();
  const VkBufferImageCopy copy{.bufferOffset = offset,
                               .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, desc.layers},
                               .imageExtent = {desc.width, desc.height, 1}};
  vkCmdCopyBufferToImage(commands, staging, image.vk(), kDst, 1, &copy);
}

void record_blits(VkCommandBuffer commands, gpu::Image& image) {
  const std::uint32_t mips = image.desc().mips;
  constexpr VkImageLayout kSrc = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kDst = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  const auto change = [&](gpu::MipRange range, const gpu::Scope& before, const gpu::Scope& after,
                          gpu::Layouts layouts) {
    gpu::record(commands, gpu::image_barrier(image, before, after, layouts, range));
  };
  for (std::uint32_t mip = 1; mip < mips; ++mip) {
    change({mip - 1, 1}, gpu::kTransferWrite, gpu::kTransferRead, {kDst, kSrc});
    blit_mip(commands, image, mip);
  }
  if (mips > 1) change({0, mips - 1}, gpu::kTransferRead, kSampledByShaders, {kSrc, kSampled});
  change({mips - 1, 1}, gpu::kTransferWrite, kSampledByShaders, {kDst, kSampled});
  image.layout = kSampled;
}

void record_normal_mips(VkCommandBuffer commands, gpu::Image& image, NormalMipmapper& mipmapper) {
  constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  constexpr gpu::Scope kStores{kCompute, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
  constexpr gpu::Scope kStored{kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
  constexpr VkImageLayout kGeneral = VK_IMAGE_LAYOUT_GENERAL;
  gpu::record(commands, gpu::image_barrier(image, gpu::kTransferWrite, kStores,
                                           {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kGeneral}));
  mipmapper.record(commands, image);
  gpu::record(commands, gpu::image_barrier(image, kStored, kSampledByShaders, {kGeneral, kSampled}));
  image.layout = kSampled;
}

VkDeviceSize staged_size(const ImageSource& source) {
  return (source.texels.size() + kCopyAlignment - 1) / kCopyAlignment * kCopyAlignment;
}

// Images by way of staging memory, a batch at a time.
class Uploader {
 public:
  explicit Uploader(gpu::Device& device) : device_(device) {}

  void upload(std::span<const ImageSource> sources, std::span<gpu::Image> images) {
    VkDeviceSize total = 0;
    for (const auto& source : sources) total += staged_size(source);
    const gpu::Buffer staging(device_, total, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::MemoryUse::upload);
    const VkCommandBuffer commands = device_.begin();
    VkDeviceSize offset = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      stage(sources[i], staging.mapped().data() + offset);
      copy_level_0(commands, images[i], staging.vk(), offset);
      if (sources[i].filter == MipFilter::normals)
        record_normal_mips(commands, images[i], mipmapper());
      else
        record_blits(commands, images[i]);
      offset += staged_size(sources[i]);
    }
    device_.submit_and_wait(commands);
    if (mipmapper_) mipmapper_->reset();
  }

 private:
  static void stage(const ImageSource& source, std::byte* to) {
    if (source.filter == MipFilter::normals)
      copy_without_alpha(source.texels, to);
    else
      std::memcpy(to, source.texels.data(), source.texels.size());
  }
  // Made when a normal map comes: it compiles a shader.
  NormalMipmapper& mipmapper() { return mipmapper_ ? *mipmapper_ : mipmapper_.emplace(device_); }

  gpu::Device& device_;
  std::optional<NormalMipmapper> mipmapper_;
};

}  // namespace

gpu::Buffer make_buffer(gpu::Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage) {
  if (device.caps().host_is_device) {
    gpu::Buffer buffer(device, bytes.size(), usage, gpu::MemoryUse::upload);
    if (!bytes.empty()) std::memcpy(buffer.mapped().data(), bytes.data(), bytes.size());
    return buffer;
  }
  gpu::Buffer buffer(device, bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::device);
  if (bytes.empty()) return buffer;
  const gpu::Buffer staging(device, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::MemoryUse::upload);
  std::memcpy(staging.mapped().data(), bytes.data(), bytes.size());
  const VkCommandBuffer commands = device.begin();
  const VkBufferCopy copy{.size = bytes.size()};
  vkCmdCopyBuffer(commands, staging.vk(), buffer.vk(), 1, &copy);
  device.submit_and_wait(commands);
  return buffer;
}

std::vector<gpu::Image> make_staged_images(gpu::Device& device, std::span<const ImageSource> sources) {
  std::vector<gpu::Image> images;
  images.reserve(sources.size());
  for (const auto& source : sources) {
    const bool stored = source.filter == MipFilter::normals;
    images.emplace_back(device, source.desc, stored ? kUsage | VK_IMAGE_USAGE_STORAGE_BIT : kUsage);
  }
  Uploader uploader(device);
  for (std::size_t first = 0; first < sources.size();) {
    std::size_t last = first;
    VkDeviceSize bytes = 0;
    while (last < sources.size() && (last == first || bytes + staged_size(sources[last]) <= kBatchBytes))
      bytes += staged_size(sources[last++]);
    uploader.upload(sources.subspan(first, last - first), std::span(images).subspan(first, last - first));
    first = last;
  }
  return images;
}

std::vector<gpu::Image> make_images(gpu::Device& device, std::span<const ImageSource> sources) {
  const bool in_place = std::all_of(sources.begin(), sources.end(),
                                    [&](const ImageSource& source) { return host_can_write(device, source.desc); });
  return in_place ? make_host_images(device, sources) : make_staged_images(device, sources);
}

}  // namespace velarium::upload
