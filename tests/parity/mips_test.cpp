// The mips that the host makes are those that the device's blit makes of the same level.

#include "upload/mips.hpp"
#include "upload/transfer.hpp"

#include "gpu/barrier.hpp"
#include "support/device_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

namespace velarium::upload {
namespace {

using Bytes = std::vector<std::byte>;

std::uint32_t half(std::uint32_t size) {
  return std::max(size / 2, 1u);
}

Bytes noise(std::size_t count) {
  std::mt19937 random(7);
  Bytes bytes(count);
  std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::byte>(random() & 0xff); });
  return bytes;
}

// Levels 0 and 1 of layer 0.
struct Levels {
  Bytes first, second;
};

Levels read_levels(gpu::Device& device, gpu::Image& image) {
  const auto& desc = image.desc();
  const std::size_t first = std::size_t{4} * desc.width * desc.height;
  const std::size_t second = std::size_t{4} * half(desc.width) * half(desc.height);
  const gpu::Buffer buffer(device, first + second, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::readback);
  const std::array copies{VkBufferImageCopy{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                            .imageExtent = {desc.width, desc.height, 1}},
                          VkBufferImageCopy{.bufferOffset = first,
                                            .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 1, 0, 1},
                                            .imageExtent = {half(desc.width), half(desc.height), 1}}};
  const VkCommandBuffer commands = device.begin();
  gpu::record(commands, gpu::image_barrier(image, gpu::kAllWork, gpu::kTransferRead,
                                           {image.layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}));
  vkCmdCopyImageToBuffer(commands, image.vk(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.vk(), 2, copies.data());
  gpu::record(commands, gpu::memory_barrier(gpu::kTransferWrite, gpu::kHostRead));
  device.submit_and_wait(commands);
  const auto mapped = buffer.mapped();
  return {{mapped.begin(), mapped.begin() + static_cast<std::ptrdiff_t>(first)},
          {mapped.begin() + static_cast<std::ptrdiff_t>(first),
           mapped.begin() + static_cast<std::ptrdiff_t>(first + second)}};
}

// What the device makes of noise; two layers, so that it is not the host that makes it.
Levels blitted(gpu::Device& device, std::uint32_t width, std::uint32_t height, bool srgb) {
  const gpu::ImageDesc desc{.format = srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                            .width = width,
                            .height = height,
                            .layers = 2,
                            .mips = gpu::full_mip_count(width, height)};
  const Bytes texels = noise(std::size_t{8} * width * height);
  const std::array sources{ImageSource{desc, texels}};
  auto images = make_images(device, sources);
  return read_levels(device, images.front());
}

struct Errors {
  int worst = 0;
  double mean = 0.0;
};

Errors errors(std::uint32_t width, std::uint32_t height, bool srgb) {
  gpu::Device device(test::device_choice(), true);
  Levels levels = blitted(device, width, height, srgb);
  Bytes made(levels.second.size());
  make_mip({levels.first.data(), std::size_t{4} * width, width, height},
           {made.data(), std::size_t{4} * half(width), half(width), half(height)}, srgb);
  Errors result;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const int difference = static_cast<int>(made[i]) - static_cast<int>(levels.second[i]);
    result.worst = std::max(result.worst, std::abs(difference));
    result.mean += difference;
  }
  result.mean /= static_cast<double>(made.size());
  return result;
}

// Where sizes are halved exactly there is nothing but rounding. llvmpipe rounds sRGB to the nearest code, and its blit
// of UNORM lies up to one code above the mean: half a code on average, and more with each level.
TEST(MipParity, ExactHalves) {
  for (const auto& [width, height] : {std::pair{64u, 64u}, std::pair{128u, 32u}}) {
    EXPECT_LE(errors(width, height, false).worst, 1);
    const Errors srgb = errors(width, height, true);
    EXPECT_LE(srgb.worst, 1);
    EXPECT_LT(std::abs(srgb.mean), 0.05);
  }
}

// Weights between texels have 8 bits or so in devices too: another code.
TEST(MipParity, OddSizes) {
  for (const bool srgb : {false, true}) {
    const Errors odd = errors(63, 41, srgb);
    EXPECT_LE(odd.worst, 2);
    EXPECT_LT(std::abs(odd.mean), 0.6);
  }
}

}  // namespace
}  // namespace velarium::upload
