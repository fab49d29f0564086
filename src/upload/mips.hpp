#pragma once

#include <cstddef>
#include <cstdint>

namespace velarium::upload {

// One level of an 8-bit RGBA image in memory, row after row from the top.
struct TexelRows {
  std::byte* first = nullptr;
  std::size_t pitch = 0;  // bytes from one row to the next
  std::uint32_t width = 0, height = 0;
};

// Fills `to` from the level above it, as vkCmdBlitImage with a linear filter does (Vulkan 1.3, "Image Copies With
// Scaling"): each texel is the mean of the two by two around its centre, weighted by their distance from it, and
// colours of sRGB images are averaged as light. Precondition: `to` is half as wide and high, rounded down, and at
// least 1.
void make_mip(const TexelRows& from, const TexelRows& to, bool srgb);

}  // namespace velarium::upload
