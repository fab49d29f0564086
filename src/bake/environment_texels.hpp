#pragma once

// An equirectangular picture as half floats, on the CPU.

#include "image/image.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace velarium::bake {

// Nearest half, ties to even. 0 <= x <= 65504.
[[nodiscard]] inline std::uint16_t half_from_float(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  // Below the smallest normal half, 2^-14, halves are multiples of 2^-24, and so are floats from 0.5 on.
  if (x < 0x1p-14f) return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(x + 0.5f) - 0x3f000000u);
  const std::uint32_t rounded = bits + 0xfffu + ((bits >> 13) & 1u);
  return static_cast<std::uint16_t>((rounded >> 13) - ((127 - 15) << 10));
}

// All mips as rgba16f, mip 0 first, rows tightly packed; values are clamped to 65504, alpha is 1.
// A pixel of a smaller mip is the mean radiance of its pixels by solid angle, so that small lights keep their power.
[[nodiscard]] std::vector<std::uint16_t> half_mips(const image::FloatImage& equirect);

}  // namespace velarium::bake
