// Mips of normal maps that the host makes are those that the device makes.

#include "upload/normal_mips.hpp"
#include "upload/transfer.hpp"

#include "gpu/barrier.hpp"
#include "support/device_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <vector>

namespace velarium::upload {
namespace {

using Bytes = std::vector<std::byte>;

std::uint32_t mip_size(std::uint32_t size, std::uint32_t mip) {
  return std::max(size >> mip, 1u);
}

std::size_t level_bytes(const gpu::ImageDesc& desc, std::uint32_t mip) {
  return std::size_t{4} * mip_size(desc.width, mip) * mip_size(desc.height, mip);
}

// Normals of any length that lean at most by half a right angle, and alpha that means nothing.
Bytes leaning_normals(std::size_t texels) {
  std::mt19937 random(5);
  Bytes bytes;
  for (std::size_t i = 0; i < texels; ++i) {
    const auto code = [&](std::uint32_t low, std::uint32_t count) {
      bytes.push_back(static_cast<std::byte>(low + random() % count));
    };
    code(83, 90);
    code(83, 90);
    code(192, 64);
    code(0, 256);
  }
  return bytes;
}

Bytes read_level(gpu::Device& device, gpu::Image& image, std::uint32_t mip) {
  const auto& desc = image.desc();
  const gpu::Buffer buffer(device, level_bytes(desc, mip), VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::readback);
  const VkBufferImageCopy copy{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1},
                               .imageExtent = {mip_size(desc.width, mip), mip_size(desc.height, mip), 1}};
  const VkCommandBuffer commands = device.begin();
  constexpr VkImageLayout kSource = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  gpu::record(commands, gpu::image_barrier(image, gpu::kAllWork, gpu::kTransferRead, {image.layout, kSource}));
  image.layout = kSource;
  vkCmdCopyImageToBuffer(commands, image.vk(), kSource, buffer.vk(), 1, &copy);
  gpu::record(commands, gpu::memory_barrier(gpu::kTransferWrite, gpu::kHostRead));
  device.submit_and_wait(commands);
  const auto mapped = buffer.mapped().first(level_bytes(desc, mip));
  return {mapped.begin(), mapped.end()};
}

// Every level, as the host makes them.
std::vector<Bytes> host_levels(const gpu::ImageDesc& desc, const Bytes& texels) {
  std::vector<Bytes> levels;
  std::vector<TexelRows> rows;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) levels.emplace_back(level_bytes(desc, mip));
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) {
    const std::uint32_t width = mip_size(desc.width, mip);
    rows.push_back({levels[mip].data(), std::size_t{4} * width, width, mip_size(desc.height, mip)});
  }
  copy_without_alpha(texels, levels.front().data());
  make_normal_mips(rows);
  return levels;
}

int worst_difference(const Bytes& a, const Bytes& b) {
  int worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i])));
  return worst;
}

void expect_the_same(gpu::Device& device, std::uint32_t width, std::uint32_t height, int most) {
  const gpu::ImageDesc desc{
      .format = VK_FORMAT_R8G8B8A8_UNORM, .width = width, .height = height, .mips = gpu::full_mip_count(width, height)};
  const Bytes texels = leaning_normals(std::size_t{width} * height);
  const std::array sources{ImageSource{desc, texels, MipFilter::normals}};
  auto images = make_staged_images(device, sources);
  const auto expected = host_levels(desc, texels);
  EXPECT_EQ(read_level(device, images.front(), 0), expected[0]);
  for (std::uint32_t mip = 1; mip < desc.mips; ++mip)
    EXPECT_LE(worst_difference(read_level(device, images.front(), mip), expected[mip]), most)
        << width << "x" << height << ", level " << mip;
}

// Both round to the nearest code; a code may fall to either side. Weights of odd sizes have 8 bits on the host.
TEST(NormalMipParity, DeviceAgreesWithHost) {
  gpu::Device device(test::device_choice(), true);
  expect_the_same(device, 64, 32, 1);
  expect_the_same(device, 61, 18, 2);
  expect_the_same(device, 1, 7, 2);
}

}  // namespace
}  // namespace velarium::upload
