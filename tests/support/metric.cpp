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

// Calls `visit` with each difference; false where the two cannot be compared.
template <class Visit>
bool visit_differences(std::span<const float> a, std::span<const float> b, Visit visit) {
  if (a.size() != b.size() || a.empty()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = double{a[i]} - double{b[i]};
    if (std::isnan(difference)) return false;
    visit(difference);
  }
  return true;
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

double mean_squared_error(std::span<const float> a, std::span<const float> b) {
  double sum = 0.0;
  if (!visit_differences(a, b, [&](double difference) { sum += difference * difference; })) return kNaN;
  return sum / static_cast<double>(a.size());
}

double psnr_db(std::span<const float> a, std::span<const float> b) {
  return -10.0 * std::log10(mean_squared_error(a, b));
}

double largest_error(std::span<const float> a, std::span<const float> b) {
  double worst = 0.0;
  if (!visit_differences(a, b, [&](double difference) { worst = std::max(worst, std::abs(difference)); })) return kNaN;
  return worst;
}

}  // namespace velarium::test
