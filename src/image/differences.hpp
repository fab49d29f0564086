#pragma once

// How much the values of two pictures differ, as numbers.

#include "image/image.hpp"

#include <cstdint>
#include <vector>

namespace velarium::image {

// Which pixels count: one value a pixel, not 0 where it does. Empty: all.
using Mask = std::vector<std::uint8_t>;

struct Differences {
  std::uint64_t pixels = 0;  // that count
  double rmse = 0.0;         // root of the mean squared difference
  double psnr_db = 0.0;      // -20 log10(rmse): the peak is 1; infinite for equal pictures
  double relative_mse = 0.0;
  double share = 0.0;          // of pixels with a channel that differs by more than the tolerance
  double largest = 0.0;        // difference of a channel
  std::uint32_t x = 0, y = 0;  // where it is
};

// Over red, green and blue, and over alpha where either picture is not opaque.
//
// The relative mean squared error divides the square of each difference by that of the reference's value plus 0.01,
// which keeps dark pixels from counting without bound (Rousselle, Knaus, Zwicker: "Adaptive Sampling and Reconstruction
// using Greedy Error Minimization", ACM Trans. Graph. 30(6), 2011). It is the only one that is not symmetric.
//
// Precondition: equal sizes, finite values, and a pixel at least that counts.
[[nodiscard]] Differences differences(const FloatImage& picture, const FloatImage& reference, const Mask& mask,
                                      float tolerance);

[[nodiscard]] bool is_opaque(const FloatImage& image);

// Of one value a pixel, over those that count.
[[nodiscard]] double mean(const std::vector<float>& values, const Mask& mask);

}  // namespace velarium::image
