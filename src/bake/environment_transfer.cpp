#include "bake/environment_transfer.hpp"

#include "core/assert.hpp"
#include "gpu/barrier.hpp"
#include "gpu/buffer.hpp"

#include <algorithm>
#include <cstring>

namespace velarium::bake {
namespace {

constexpr std::size_t kTexelBytes = 8;  // rgba16f

constexpr VkImageUsageFlags kUploadedUsage =
    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

std::size_t mip_bytes(const gpu::ImageDesc& desc, std::uint32_t mip) {
  return kTexelBytes * std::max(desc.width >> mip, 1u) * std::max(desc.height >> mip, 1u) * desc.layers;
}

std::vector<VkBufferImageCopy> copies_of_all_mips(const gpu::ImageDesc& desc) {
  std::vector<VkBufferImageCopy> copies;
  VkDeviceSize offset = 0;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) {
    copies.push_back({.bufferOffset = offset,
                      .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, desc.layers},
                      .imageExtent = {std::max(desc.width >> mip, 1u), std::max(desc.height >> mip, 1u), 1}});
    offset += mip_bytes(desc, mip);
  }
  return copies;
}

}  // namespace

std::size_t half_image_bytes(const gpu::ImageDesc& desc) {
  std::size_t bytes = 0;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) bytes += mip_bytes(desc, mip);
  return bytes;
}

void change_layout(VkCommandBuffer commands, gpu::Image& image, VkImageLayout layout) {
  gpu::record(commands, gpu::image_barrier(image, gpu::kAllWrites, gpu::kAllWork, {image.layout, layout}));
  image.layout = layout;
}

gpu::Image upload_half_image(gpu::Device& device, const gpu::ImageDesc& desc, std::span<const std::byte> bytes) {
  VEL_ASSERT(bytes.size() == half_image_bytes(desc));
  gpu::Image image(device, desc, kUploadedUsage);
  const gpu::Buffer staging(device, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::MemoryUse::upload);
  std::memcpy(staging.mapped().data(), bytes.data(), bytes.size());
  const auto copies = copies_of_all_mips(desc);
  const VkCommandBuffer commands = device.begin();
  change_layout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  vkCmdCopyBufferToImage(commands, staging.vk(), image.vk(), image.layout, static_cast<std::uint32_t>(copies.size()),
                         copies.data());
  change_layout(commands, image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  device.submit_and_wait(commands);
  return image;
}

void download_half_image(gpu::Device& device, gpu::Image& image, std::span<std::byte> bytes) {
  VEL_ASSERT(bytes.size() == half_image_bytes(image.desc()));
  const gpu::Buffer staging(device, bytes.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::readback);
  const auto copies = copies_of_all_mips(image.desc());
  const VkCommandBuffer commands = device.begin();
  change_layout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  vkCmdCopyImageToBuffer(commands, image.vk(), image.layout, staging.vk(), static_cast<std::uint32_t>(copies.size()),
                         copies.data());
  change_layout(commands, image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  gpu::record(commands, gpu::memory_barrier(gpu::kTransferWrite, gpu::kHostRead));
  device.submit_and_wait(commands);
  std::memcpy(bytes.data(), staging.mapped().data(), bytes.size());
}

}  // namespace velarium::bake
