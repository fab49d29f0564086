#pragma once

#include "upload/transfer.hpp"

namespace velarium::upload {

// May make_host_images() make this image? Where the device is the host and samples linear images of 8-bit RGBA.
[[nodiscard]] bool host_can_write(const gpu::Device& device, const gpu::ImageDesc& desc);

// As make_images(), written in place on all cores: no staging memory, no copies, and no pipelines to compile for blits.
// Precondition: host_can_write() for each.
[[nodiscard]] std::vector<gpu::Image> make_host_images(gpu::Device& device, std::span<const ImageSource> sources);

}  // namespace velarium::upload
