#include "image/separable_filter.hpp"

#include "core/assert.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace velarium::image {
namespace {

void add_scaled(const float* from, float scale, std::span<float> to) {
  float* const target = to.data();
  const std::size_t size = to.size();
  for (std::size_t x = 0; x < size; ++x) target[x] += scale * from[x];
}

}  // namespace

Kernel gaussian(double sigma, std::size_t radius) {
  std::vector<double> weights;
  for (std::size_t i = 0; i <= 2 * radius; ++i) {
    const double x = static_cast<double>(i) - static_cast<double>(radius);
    weights.push_back(std::exp(-x * x / (2.0 * sigma * sigma)));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  Kernel kernel;
  for (const double weight : weights) kernel.taps.push_back(static_cast<float>(weight / sum));
  return kernel;
}

Kernel trimmed(Kernel kernel) {
  // Half of the last bit of a float that holds a value near 1.
  constexpr float kUnseen = 0x1p-25f;
  const auto seen = std::find_if(kernel.taps.begin(), kernel.taps.end(), [](float w) { return std::abs(w) > kUnseen; });
  const auto unseen =
      std::min<std::ptrdiff_t>(seen - kernel.taps.begin(), static_cast<std::ptrdiff_t>(kernel.radius()));
  return {std::vector<float>(kernel.taps.begin() + unseen, kernel.taps.end() - unseen)};
}

void filter_row(std::span<const float> from, const Kernel& kernel, std::size_t padding, std::span<float> to) {
  VEL_ASSERT(kernel.radius() <= padding && from.size() == to.size() + 2 * padding);
  std::fill(to.begin(), to.end(), 0.0f);
  const float* const first = from.data() + padding - kernel.radius();
  for (std::size_t i = 0; i < kernel.taps.size(); ++i) add_scaled(first + i, kernel.taps[i], to);
}

void add_filtered_column(std::span<const float> rows, std::size_t first, const Kernel& kernel, std::span<float> to) {
  VEL_ASSERT((first + kernel.taps.size()) * to.size() <= rows.size());
  const float* const top = rows.data() + first * to.size();
  for (std::size_t i = 0; i < kernel.taps.size(); ++i) add_scaled(top + i * to.size(), kernel.taps[i], to);
}

void pad_row(std::span<float> row, std::size_t padding) {
  std::fill_n(row.begin(), padding, row[padding]);
  std::fill_n(row.end() - static_cast<std::ptrdiff_t>(padding), padding, row[row.size() - padding - 1]);
}

}  // namespace velarium::image
