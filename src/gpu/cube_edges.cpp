#include "gpu/cube_edges.hpp"

#include "gpu/barrier.hpp"

namespace velarium::gpu {
namespace {

// One texel of each mip, all layers: mip m goes to column m.
std::vector<VkImageBlit2> blits_of_corners(const ImageDesc& cube) {
  std::vector<VkImageBlit2> regions;
  for (std::uint32_t mip = 0; mip < cube.mips; ++mip) {
    const auto column = static_cast<std::int32_t>(mip);
    regions.push_back({.sType = VK_STRUCTURE_TYPE_IMAGE_BLIT_2,
                       .srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, cube.layers},
                       .srcOffsets = {{0, 0, 0}, {1, 1, 1}},
                       .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, cube.layers},
                       .dstOffsets = {{column, 0, 0}, {column + 1, 1, 1}}});
  }
  return regions;
}

}  // namespace

void fill_cube_edges(Device& device, Image& cube) {
  if (!device.caps().cube_edges_need_blit) return;
  const ImageDesc& desc = cube.desc();
  const Image unread(device, {.format = desc.format, .width = desc.mips, .layers = desc.layers},
                     VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
  const auto regions = blits_of_corners(desc);
  constexpr VkImageLayout kFrom = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kTo = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  const VkBlitImageInfo2 blit{.sType = VK_STRUCTURE_TYPE_BLIT_IMAGE_INFO_2,
                              .srcImage = cube.vk(),
                              .srcImageLayout = kFrom,
                              .dstImage = unread.vk(),
                              .dstImageLayout = kTo,
                              .regionCount = static_cast<std::uint32_t>(regions.size()),
                              .pRegions = regions.data(),
                              .filter = VK_FILTER_NEAREST};
  const VkCommandBuffer commands = device.begin();
  record(commands, image_barrier(unread, {}, kTransferWrite, {VK_IMAGE_LAYOUT_UNDEFINED, kTo}));
  record(commands, image_barrier(cube, kAllWrites, kTransferRead, {cube.layout, kFrom}));
  vkCmdBlitImage2(commands, &blit);
  record(commands, image_barrier(cube, kTransferRead, kAllWork, {kFrom, cube.layout}));
  device.submit_and_wait(commands);
}

}  // namespace velarium::gpu
