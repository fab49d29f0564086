#include "gpu/null_resources.hpp"

#include "core/assert.hpp"
#include "gpu/barrier.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace velarium::gpu {
namespace {

// As large as the largest table of fixed size may be: a block must fit into what is bound for it.
constexpr VkDeviceSize kBufferBytes = 4096;

constexpr VkFormat kColor = VK_FORMAT_R8G8B8A8_UNORM, kDepth = VK_FORMAT_D32_SFLOAT;

struct NullDesc {
  SlotType type;
  ImageDesc desc;
};
constexpr std::array kNulls{NullDesc{SlotType::texture2D, {.format = kColor}},
                            NullDesc{SlotType::texture2DArray, {.format = kColor, .array = true}},
                            NullDesc{SlotType::sampler2DArray, {.format = kColor, .array = true}},
                            NullDesc{SlotType::textureCube, {.format = kColor, .layers = 6, .cube = true}},
                            NullDesc{SlotType::utexture2D, {.format = VK_FORMAT_R8_UINT}},
                            NullDesc{SlotType::depth_texture2D, {.format = kDepth}},
                            NullDesc{SlotType::depth_texture2DArray, {.format = kDepth, .array = true}}};

void clear(VkCommandBuffer commands, const Image& image) {
  const VkImageSubresourceRange all{aspects(image.desc().format), 0, VK_REMAINING_MIP_LEVELS, 0,
                                    VK_REMAINING_ARRAY_LAYERS};
  constexpr VkImageLayout kLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  record(commands, image_barrier(image, {}, kTransferWrite, {VK_IMAGE_LAYOUT_UNDEFINED, kLayout}));
  if (has_depth(image.desc().format)) {
    const VkClearDepthStencilValue zero{};
    vkCmdClearDepthStencilImage(commands, image.vk(), kLayout, &zero, 1, &all);
  } else {
    const VkClearColorValue zero{};
    vkCmdClearColorImage(commands, image.vk(), kLayout, &zero, 1, &all);
  }
  record(commands, image_barrier(image, kTransferWrite, kAllWork, {kLayout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}));
}

}  // namespace

void NullResources::make() {
  if (buffer_) return;
  buffer_ = Buffer(device_, kBufferBytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, MemoryUse::upload);
  std::ranges::fill(buffer_.mapped(), std::byte{0});
  const VkCommandBuffer commands = device_.begin();
  for (const auto& null : kNulls) {
    auto& image = images_[null.type];
    image = Image(device_, null.desc, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    clear(commands, image);
    image.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  }
  device_.submit_and_wait(commands);
}

const Image& NullResources::image(SlotType type) const {
  const auto found = images_.find(type);
  VEL_ASSERT(found != images_.end());
  return found->second;
}

}  // namespace velarium::gpu
