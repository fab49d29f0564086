#include "image/ssim.hpp"

#include "core/assert.hpp"
#include "core/jobs.hpp"
#include "image/separable_filter.hpp"

#include <algorithm>
#include <array>

namespace velarium::image {
namespace {

// The paper's window, and its constants for values from 0 to 1.
constexpr std::size_t kRadius = 5;
constexpr double kSigma = 1.5;
constexpr float kC1 = 0.01f * 0.01f, kC2 = 0.03f * 0.03f;

constexpr std::size_t kBandRows = 48;  // as those of FLIP

// Weighted sums of a neighbourhood's values, by which means, variances and the covariance are known. The square of the
// difference stands for the product: it makes equal pictures exactly 1, and loses no digits where they nearly are.
enum SceneSnapshot { kPicture, kReference, kSquares, kDifferenceSquares, kMoments };
using Rows = std::array<std::vector<float>, kMoments>;

struct Pair {
  const FloatImage& picture;
  const FloatImage& reference;
};

void read_row(const Pair& pair, std::size_t y, std::size_t channel, Rows& row) {
  const std::size_t width = pair.picture.width;
  for (std::size_t x = 0; x < width; ++x) {
    const std::size_t i = 4 * (y * width + x) + channel;
    const float p = pair.picture.rgba[i], q = pair.reference.rgba[i];
    row[kPicture][x + kRadius] = p;
    row[kReference][x + kRadius] = q;
    row[kSquares][x + kRadius] = p * p + q * q;
    row[kDifferenceSquares][x + kRadius] = (p - q) * (p - q);
  }
  for (auto& values : row) pad_row(values, kRadius);
}

// SSIM with 2 x y = x^2 + y^2 - (x - y)^2 in both of its factors.
float similarity(float p, float q, float squares, float difference_squares) {
  const float d = p - q;
  const float mean_squares = p * p + q * q;
  const float variances = std::max(squares - mean_squares, 0.0f);
  const float difference_variance = std::max(difference_squares - d * d, 0.0f);
  return (1.0f - d * d / (mean_squares + kC1)) * (1.0f - difference_variance / (variances + kC2));
}

// Adds a third of one channel's similarity to the rows [begin, end) of the map.
void add_band(const Pair& pair, std::size_t begin, std::size_t end, std::size_t channel, const Kernel& window,
              std::vector<float>& map) {
  const std::size_t width = pair.picture.width, rows = end - begin + 2 * kRadius;
  Rows row, filtered, sums;
  for (auto& values : row) values.resize(width + 2 * kRadius);
  for (auto& values : filtered) values.resize(rows * width);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t y = std::clamp(begin + i, kRadius, kRadius + pair.picture.height - 1) - kRadius;
    read_row(pair, y, channel, row);
    for (std::size_t m = 0; m < kMoments; ++m)
      filter_row(row[m], window, kRadius, std::span(filtered[m]).subspan(i * width, width));
  }
  for (std::size_t y = begin; y < end; ++y) {
    for (std::size_t m = 0; m < kMoments; ++m) {
      sums[m].assign(width, 0.0f);
      add_filtered_column(filtered[m], y - begin, window, sums[m]);
    }
    for (std::size_t x = 0; x < width; ++x)
      map[y * width + x] +=
          similarity(sums[kPicture][x], sums[kReference][x], sums[kSquares][x], sums[kDifferenceSquares][x]) / 3.0f;
  }
}

}  // namespace

std::vector<float> ssim(const FloatImage& picture, const FloatImage& reference) {
  VEL_ASSERT(picture.width == reference.width && picture.height == reference.height);
  const Kernel window = gaussian(kSigma, kRadius);
  const std::size_t height = picture.height;
  std::vector<float> map(height * picture.width, 0.0f);
  parallel_for((height + kBandRows - 1) / kBandRows, [&](std::size_t i) {
    for (std::size_t channel = 0; channel < 3; ++channel)
      add_band({picture, reference}, i * kBandRows, std::min((i + 1) * kBandRows, height), channel, window, map);
  });
  return map;
}

Mask inside_for_ssim(const Mask& mask, std::uint32_t width, std::uint32_t height) {
  Mask inside(static_cast<std::size_t>(width) * height, 0);
  for (std::size_t y = kRadius; y + kRadius < height; ++y) {
    for (std::size_t x = kRadius; x + kRadius < width; ++x) {
      const std::size_t i = y * width + x;
      inside[i] = mask.empty() || mask[i] != 0 ? 1 : 0;
    }
  }
  const bool any = std::find(inside.begin(), inside.end(), 1) != inside.end();
  return any ? inside : mask;
}

}  // namespace velarium::image
