#pragma once

#include <cstdint>
#include <vector>

namespace velarium::bake {

// The table behind bfn_encode() of shading/normal_encoding.glsl [Kaplanyan 2010]: R8 UNORM, size x size texels, laid
// out as bfn_table_texel() reads it. A texel holds the k in 1..127 for which k times the texel's direction, scaled to a
// largest component of 1 and rounded to integers, errs least in angle; of equal ones the largest. Each direction is
// that of the texel's centre. 1024 leaves a mean error of 0.032 degrees, 512 of 0.038, 128 of 0.10, no table 0.17.
// size >= 2.
[[nodiscard]] std::vector<std::uint8_t> best_fit_normal_lengths(std::uint32_t size);

// The same, computed once on this machine.
[[nodiscard]] std::vector<std::uint8_t> cached_best_fit_normal_lengths(std::uint32_t size);

}  // namespace velarium::bake
