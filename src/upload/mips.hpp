#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace velarium::upload {

// One level of an 8-bit RGBA image in memory, row after row from the top.
struct TexelRows {
  std::byte* first = nullptr;
  std::size_t pitch = 0;  // bytes from one row to the next
  std::uint32_t width = 0, height = 0;
};

// The two texels around the centre of a smaller level's texel, and how much of the second, in 256ths.
struct Tap {
  std::uint32_t first, second;
  std::uint32_t weight;
  [[nodiscard]] float share() const { return static_cast<float>(weight) / 256.0f; }
};

// Of each of `to` texels along a side of `from`. Precondition: to <= from.
[[nodiscard]] std::vector<Tap> make_taps(std::uint32_t from, std::uint32_t to);

// Fills `to` from the level above it, as vkCmdBlitImage with a linear filter does (Vulkan 1.3, "Image Copies With
// Scaling"): each texel is the mean of the two by two around its centre, weighted by their distance from it, and
// colours of sRGB images are averaged as light. Precondition: `to` is half as wide and high, rounded down, and at
// least 1.
void make_mip(const TexelRows& from, const TexelRows& to, bool srgb);

}  // namespace velarium::upload
