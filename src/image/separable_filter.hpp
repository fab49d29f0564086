#pragma once

// Convolution of rows of pixels by kernels that are products of two one-dimensional ones.

#include <cstddef>
#include <span>
#include <vector>

namespace velarium::image {

// An odd number of weights; the middle one is for the pixel itself.
struct Kernel {
  std::vector<float> taps;
  [[nodiscard]] std::size_t radius() const { return taps.size() / 2; }
};

// exp(-x^2 / (2 sigma^2)) at the whole numbers from -radius to radius, sum 1.
[[nodiscard]] Kernel gaussian(double sigma, std::size_t radius);

// Without outer weights that are too small to be seen in a sum of floats.
[[nodiscard]] Kernel trimmed(Kernel kernel);

// to[x] = sum of kernel[i] from[x + padding - radius + i]. `from` holds `padding` more values on either side than
// `to`. Precondition: radius <= padding.
void filter_row(std::span<const float> from, const Kernel& kernel, std::size_t padding, std::span<float> to);

// Adds to `to` the sum of kernel[i] times row i of those around the wanted one. `rows` holds whole rows as long as
// `to`, of which row `first` is the uppermost that the kernel covers.
void add_filtered_column(std::span<const float> rows, std::size_t first, const Kernel& kernel, std::span<float> to);

// Repeats the values at both ends `padding` times. `row` holds the values in its middle.
void pad_row(std::span<float> row, std::size_t padding);

}  // namespace velarium::image
