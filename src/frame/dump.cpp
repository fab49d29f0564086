#include "frame/dump.hpp"

#include "core/assert.hpp"
#include "gpu/barrier.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cstring>

namespace velarium::frame {
namespace {

std::size_t texel_bytes(VkFormat format) {
  switch (format) {
    case VK_FORMAT_D16_UNORM:
      return 2;
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_R8G8B8A8_SRGB:
    case VK_FORMAT_R32_SFLOAT:
    case VK_FORMAT_D32_SFLOAT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT:
      return 4;  // depth alone is copied
    case VK_FORMAT_R16G16B16A16_SFLOAT:
      return 8;
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return 16;
    default:
      return 0;
  }
}

void widen(VkFormat format, const std::byte* texel, float* out) {
  if (format == VK_FORMAT_D32_SFLOAT_S8_UINT || format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_R32_SFLOAT) {
    std::memcpy(out, texel, sizeof(float));
    out[1] = out[2] = out[0];
    out[3] = 1.0f;
  } else if (format == VK_FORMAT_D16_UNORM) {
    std::uint16_t depth = 0;
    std::memcpy(&depth, texel, sizeof(depth));
    out[0] = out[1] = out[2] = static_cast<float>(depth) / 65535.0f;
    out[3] = 1.0f;
  } else if (format == VK_FORMAT_R16G16B16A16_SFLOAT) {
    std::uint64_t packed = 0;
    std::memcpy(&packed, texel, sizeof(packed));
    const glm::vec4 value = glm::unpackHalf4x16(packed);
    std::memcpy(out, &value, sizeof(value));
  } else if (format == VK_FORMAT_R32G32B32A32_SFLOAT) {
    std::memcpy(out, texel, 4 * sizeof(float));
  } else {
    for (int i = 0; i < 4; ++i) out[i] = static_cast<float>(std::to_integer<int>(texel[i])) / 255.0f;
  }
}

void record_copy(VkCommandBuffer commands, const gpu::Image& image, VkBuffer to) {
  const auto aspect = gpu::has_depth(image.desc().format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  gpu::record(commands, gpu::image_barrier(image, gpu::kAllWrites, gpu::kTransferRead,
                                           {image.layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}));
  const VkBufferImageCopy copy{.imageSubresource = {static_cast<VkImageAspectFlags>(aspect), 0, 0, 1},
                               .imageExtent = {image.desc().width, image.desc().height, 1}};
  vkCmdCopyImageToBuffer(commands, image.vk(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1, &copy);
  gpu::record(commands, gpu::memory_barrier(gpu::kTransferWrite, gpu::kHostRead));
}

}  // namespace

void check_dump_names(const graph::Executor& executor, const std::vector<std::string>& names) {
  const auto known = executor.image_names();
  for (const auto& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const auto near = nearest_name(name, known);
    throw Error(ErrorCode::usage,
                fmt::format("no image '{}' to dump{}; there are {}", name,
                            near.empty() ? "" : ", did you mean '" + near + "'?", fmt::join(known, ", ")));
  }
}

DumpedImage dump_image(gpu::Device& device, graph::Executor& executor, const std::string& name) {
  gpu::Image* image = executor.find_image(name);
  VEL_ASSERT(image != nullptr);
  const auto& desc = image->desc();
  const std::size_t pixels = std::size_t{desc.width} * desc.height, bytes = texel_bytes(desc.format);
  const gpu::Buffer staging(device, pixels * bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::readback);
  const VkCommandBuffer commands = device.begin();
  record_copy(commands, *image, staging.vk());
  image->layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  device.submit_and_wait(commands);

  DumpedImage result{name, desc.width, desc.height, std::vector<float>(4 * pixels)};
  for (std::size_t i = 0; i < pixels; ++i)
    widen(desc.format, staging.mapped().data() + i * bytes, result.rgba.data() + 4 * i);
  return result;
}

}  // namespace velarium::frame
