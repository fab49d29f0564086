#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace velarium::reference {

// The random numbers of one light path: Owen-scrambled Sobol points, padded [Burley 2020, "Practical Hash-based Owen
// Scrambling"]. Each draw is a (0,2)-sequence of its own over the samples of a pixel, shuffled and scrambled by
// (pixel, draw, seed): the first 2^k samples, and each aligned block of 2^k, put one point into every elementary
// interval of area 2^-k, and draws have nothing to do with each other. The n-th draw of two samples of a pixel must
// therefore decide the same thing, or the points of that decision are no longer well spread.
//
// Only integers decide, up to the last conversion: the numbers are the same on every machine.
class Sequence {
 public:
  // sample: counted from 0 within the pixel; every value is allowed.
  Sequence(glm::uvec2 pixel, std::uint32_t sample, std::uint32_t seed);

  // In [0, 1), multiples of 2^-24.
  [[nodiscard]] float next_1d();
  [[nodiscard]] glm::vec2 next_2d();

 private:
  [[nodiscard]] std::uint32_t next_seed();

  std::uint32_t sample_, path_seed_, draw_ = 0;
};

}  // namespace velarium::reference
