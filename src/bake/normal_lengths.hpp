#pragma once

#include <cstdint>
#include <vector>

namespace velarium::bake {

// The table behind bfn_encode() of shading/normal_encoding.glsl [Kaplanyan 2010]: R8 UNORM, size x size texels, rows of
// increasing bfn_table_uv().y. A texel holds the odd k in 1..255 for which k times the texel's direction, scaled to a
// largest component of 1 and rounded to odd integers, errs least in angle; of equal ones the largest. Each direction
// is that of the texel's centre. 1024 leaves a mean error of 0.032 degrees, 512 of 0.040; below 128 it gains nothing.
// size >= 1.
[[nodiscard]] std::vector<std::uint8_t> best_fit_normal_lengths(std::uint32_t size);

// The same, computed once on this machine.
[[nodiscard]] std::vector<std::uint8_t> cached_best_fit_normal_lengths(std::uint32_t size);

}  // namespace velarium::bake
