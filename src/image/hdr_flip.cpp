#include "image/flip.hpp"

#include "core/jobs.hpp"

#include <velarium/median.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace velarium::image {
namespace {

// Narkowicz's fit of the ACES curve, with the exposure of 0.6 that it was made for: y = (a x^2 + b x) / (c x^2 + d x +
// e). Krzysztof Narkowicz: "ACES Filmic Tone Mapping Curve", 2016; HDR-FLIP, section 3.
constexpr double kA = 0.36 * 2.51, kB = 0.6 * 0.03, kC = 0.36 * 2.43, kD = 0.6 * 0.59, kE = 0.14;

// What "nearly white" is, after the curve (HDR-FLIP, section 3).
constexpr double kNearlyWhite = 0.85;

float tone_mapped(float x) {
  // The curve is above 1 from 7 on. Beyond, its squares would leave the range of floats.
  constexpr float kWhite = 1e3f;
  const float v = std::clamp(x, 0.0f, kWhite);
  const float y = v * (static_cast<float>(kA) * v + static_cast<float>(kB)) /
                  (v * (static_cast<float>(kC) * v + static_cast<float>(kD)) + static_cast<float>(kE));
  return std::min(y, 1.0f);
}

// The light that the curve makes nearly white: its inverse there.
double nearly_white_light() {
  const double a = kA - kC * kNearlyWhite, b = kB - kD * kNearlyWhite, c = -kE * kNearlyWhite;
  return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

void expose(const FloatImage& image, float stops, FloatImage& to) {
  const float factor = std::exp2(stops);
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  parallel_for(image.height, [&](std::size_t y) {
    const float* const from = image.rgba.data() + y * row;
    std::transform(from, from + row, to.rgba.data() + y * row,
                   [&](float light) { return tone_mapped(factor * light); });
  });
}

}  // namespace

Exposures exposures_of(const FloatImage& reference) {
  using Floats = std::numeric_limits<float>;
  std::vector<float> luminances;
  luminances.reserve(reference.rgba.size() / 4);
  for (std::size_t i = 0; i < reference.rgba.size(); i += 4) {
    const auto light = [&](std::size_t channel) { return std::max(reference.rgba[i + channel], 0.0f); };
    const float y = 0.2126f * light(0) + 0.7152f * light(1) + 0.0722f * light(2);  // ITU-R BT.709
    // No factor of a float's range would show less than its smallest normal number, nor more than its largest.
    if (y >= Floats::min()) luminances.push_back(std::min(y, Floats::max()));
  }
  if (luminances.empty()) return {};
  const double white = nearly_white_light();
  const double brightest = *std::max_element(luminances.begin(), luminances.end());
  const auto first = static_cast<float>(std::log2(white / brightest));
  const auto last = static_cast<float>(std::log2(white / median(std::move(luminances))));
  if (first == last) return {first, last, 1};
  return {first, last, std::max(2, static_cast<int>(std::ceil(last - first)))};
}

std::vector<float> hdr_flip(const FloatImage& picture, const FloatImage& reference, const Exposures& exposures,
                            float pixels_per_degree) {
  FloatImage seen_picture = picture, seen_reference = reference;
  std::vector<float> errors(picture.rgba.size() / 4, 0.0f);
  for (int i = 0; i < exposures.count; ++i) {
    const float share = exposures.count == 1 ? 0.0f : static_cast<float>(i) / static_cast<float>(exposures.count - 1);
    const float stops = exposures.first + share * (exposures.last - exposures.first);
    expose(picture, stops, seen_picture);
    expose(reference, stops, seen_reference);
    const std::vector<float> at_exposure = flip(seen_picture, seen_reference, pixels_per_degree);
    std::transform(errors.begin(), errors.end(), at_exposure.begin(), errors.begin(),
                   [](float a, float b) { return std::max(a, b); });
  }
  return errors;
}

}  // namespace velarium::image
