#include "image/differences.hpp"

#include "core/assert.hpp"
#include "core/jobs.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::image {
namespace {

constexpr double kRelativeOffset = 0.01;

// Sums over a row, or over several.
struct Sums {
  std::uint64_t pixels = 0, beyond = 0;
  double squares = 0.0, relative_squares = 0.0;
  float largest = -1.0f;
  std::size_t largest_at = 0;
};

Sums sums_of_row(const FloatImage& picture, const FloatImage& reference, const Mask& mask, float tolerance,
                 std::size_t channels, std::size_t y) {
  Sums sums;
  for (std::size_t i = y * picture.width; i < (y + 1) * picture.width; ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    float worst = 0.0f;
    for (std::size_t c = 4 * i; c < 4 * i + channels; ++c) {
      const double value = reference.rgba[c], difference = double{picture.rgba[c]} - value;
      sums.squares += difference * difference;
      sums.relative_squares += difference * difference / (value * value + kRelativeOffset);
      worst = std::max(worst, static_cast<float>(std::abs(difference)));
    }
    ++sums.pixels;
    if (worst > tolerance) ++sums.beyond;
    if (worst <= sums.largest) continue;
    sums.largest = worst;
    sums.largest_at = i;
  }
  return sums;
}

// Rows are added from the top, so that the result does not depend on which thread was the first.
Sums total(const std::vector<Sums>& rows) {
  Sums sums;
  for (const Sums& row : rows) {
    sums.pixels += row.pixels;
    sums.beyond += row.beyond;
    sums.squares += row.squares;
    sums.relative_squares += row.relative_squares;
    if (row.largest <= sums.largest) continue;
    sums.largest = row.largest;
    sums.largest_at = row.largest_at;
  }
  return sums;
}

}  // namespace

bool is_opaque(const FloatImage& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 1.0f) return false;
  }
  return true;
}

Differences differences(const FloatImage& picture, const FloatImage& reference, const Mask& mask, float tolerance) {
  VEL_ASSERT(picture.width == reference.width && picture.height == reference.height);
  const std::size_t channels = is_opaque(picture) && is_opaque(reference) ? 3 : 4;
  std::vector<Sums> rows(picture.height);
  parallel_for(rows.size(),
               [&](std::size_t y) { rows[y] = sums_of_row(picture, reference, mask, tolerance, channels, y); });
  const Sums sums = total(rows);
  VEL_ASSERT(sums.pixels > 0);

  const auto pixels = static_cast<double>(sums.pixels), values = pixels * static_cast<double>(channels);
  Differences result;
  result.pixels = sums.pixels;
  result.rmse = std::sqrt(sums.squares / values);
  result.psnr_db = -20.0 * std::log10(result.rmse);
  result.relative_mse = sums.relative_squares / values;
  result.share = static_cast<double>(sums.beyond) / pixels;
  result.largest = sums.largest;
  result.x = static_cast<std::uint32_t>(sums.largest_at % picture.width);
  result.y = static_cast<std::uint32_t>(sums.largest_at / picture.width);
  return result;
}

double mean(const std::vector<float>& values, const Mask& mask) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    sum += values[i];
    ++count;
  }
  VEL_ASSERT(count > 0);
  return sum / static_cast<double>(count);
}

}  // namespace velarium::image
