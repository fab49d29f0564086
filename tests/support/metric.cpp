#include "support/metric.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace velarium::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool is_flat(const image::ByteImage& image) {
  for (std::size_t i = 4; i < image.rgba.size(); ++i)
    if (image.rgba[i] != image.rgba[i % 4]) return false;
  return true;
}

int pixel_difference(const std::uint8_t* a, const std::uint8_t* b) {
  int worst = 0;
  for (int c = 0; c < 4; ++c) worst = std::max(worst, std::abs(int{a[c]} - int{b[c]}));
  return worst;
}

}  // namespace

Verdict compare(const image::ByteImage& actual, const image::ByteImage& expected, const Tolerance& tolerance) {
  Verdict verdict;
  if (actual.width != expected.width || actual.height != expected.height) {
    verdict.says =
        fmt::format("{}x{} pixels instead of {}x{}", actual.width, actual.height, expected.width, expected.height);
    return verdict;
  }
  if (is_flat(actual)) {
    verdict.says = "every pixel has the same colour";
    return verdict;
  }
  const std::size_t pixels = actual.rgba.size() / 4;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const int difference = pixel_difference(&actual.rgba[4 * i], &expected.rgba[4 * i]);
    verdict.worst = std::max(verdict.worst, difference);
    if (difference > tolerance.max_error) ++beyond;
  }
  verdict.share = static_cast<double>(beyond) / static_cast<double>(pixels);
  verdict.same = verdict.share <= tolerance.share;
  verdict.says =
      fmt::format("{} of {} pixels ({:.3f} %, allowed {:.3f} %) differ by more than {}/255; at most by {}", beyond,
                  pixels, 100.0 * verdict.share, 100.0 * tolerance.share, tolerance.max_error, verdict.worst);
  return verdict;
}

image::ByteImage difference_picture(const image::ByteImage& a, const image::ByteImage& b) {
  image::ByteImage out{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    if (i % 4 != 3) out.rgba[i] = static_cast<std::uint8_t>(std::min(16 * std::abs(a.rgba[i] - b.rgba[i]), 255));
  return out;
}

double largest_error(std::span<const float> a, std::span<const float> b) {
  if (a.size() != b.size() || a.empty()) return kNaN;
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(double{a[i]} - double{b[i]});
    if (std::isnan(difference)) return kNaN;
    worst = std::max(worst, difference);
  }
  return worst;
}

}  // namespace velarium::test
