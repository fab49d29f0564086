#pragma once

// Half float images between host and device, all mips at once: mip 0 first, layer after layer, rows tightly packed.

#include "gpu/image.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace velarium::bake {

// Bytes of an rgba16f image with all its mips and layers.
[[nodiscard]] std::size_t half_image_bytes(const gpu::ImageDesc& desc);

// An image with these bytes, ready to be sampled; it may be copied from, too.
[[nodiscard]] gpu::Image upload_half_image(gpu::Device& device, const gpu::ImageDesc& desc,
                                           std::span<const std::byte> bytes);

// Precondition: the image may be copied from, and is ready to be sampled; so it is left.
void download_half_image(gpu::Device& device, gpu::Image& image, std::span<std::byte> bytes);

// The image into another layout, for any use after any use: baking has time.
void change_layout(VkCommandBuffer commands, gpu::Image& image, VkImageLayout layout);

}  // namespace velarium::bake
