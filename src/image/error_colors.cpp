#include "image/error_colors.hpp"

#include "image/opponent_color.hpp"
#include "image/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::image {
namespace {

// A path of our own through the gamut of sRGB, close below its surface. Lightness L* is proportional to the error; hue
// turns from violet over red and orange to yellow; chroma rises quickly and fades to that of the palest yellow.
Lab path(float t) {
  constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;
  const float hue = (300.0f + 160.0f * t) * kDegree;
  const float chroma = 55.0f * std::tanh(4.5f * t) * std::sqrt(1.0f - 0.97f * std::pow(t, 6.0f));
  return {98.0f * t, chroma * std::cos(hue), chroma * std::sin(hue)};
}

std::uint8_t to_byte(float linear) {
  return static_cast<std::uint8_t>(std::lround(255.0f * srgb_from_linear(std::clamp(linear, 0.0f, 1.0f))));
}

}  // namespace

std::array<std::uint8_t, 3> error_color(float error) {
  const Rgb color = rgb_from_lab(path(std::clamp(error, 0.0f, 1.0f)));
  return {to_byte(color.r), to_byte(color.g), to_byte(color.b)};
}

}  // namespace velarium::image
