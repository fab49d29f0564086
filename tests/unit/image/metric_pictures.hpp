#pragma once

// Pictures made by a formula, so that an independent program can make them as well.

#include "image/srgb.hpp"

#include "image/image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace velarium::image {

inline FloatImage flat(std::uint32_t width, std::uint32_t height, std::array<float, 3> color, float alpha = 1.0f) {
  FloatImage image{width, height, std::vector<float>(std::size_t{4} * width * height, alpha)};
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) image.rgba[i] = color[i % 4];
  return image;
}

inline FloatImage grey(float value) {
  return flat(24, 20, {value, value, value});
}

template <class Function>
FloatImage mapped(FloatImage image, Function function) {
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) image.rgba[i] = function(image.rgba[i]);
  return image;
}

inline constexpr std::uint32_t kPatternWidth = 48, kPatternHeight = 40;

inline std::array<std::uint32_t, 3> pattern_color(std::uint32_t x, std::uint32_t y) {
  return {x * 5 % 256, y * 6 % 256, x * y % 256};
}

// As the pattern, but a rectangle is darker, a pixel is white, and the right edge has red and blue exchanged.
inline std::array<std::uint32_t, 3> changed_color(std::uint32_t x, std::uint32_t y) {
  std::array<std::uint32_t, 3> color = pattern_color(x, y);
  if (x >= 10 && x < 30 && y >= 8 && y < 24)
    for (std::uint32_t& channel : color) channel = channel * 3 / 4;
  if (x == 20 && y == 30) color = {255, 255, 255};
  if (x >= 40) std::swap(color[0], color[2]);
  return color;
}

// Display values from 0 to 1.
template <class Color>
FloatImage picture_of(Color color_at) {
  FloatImage image{kPatternWidth, kPatternHeight, {}};
  for (std::uint32_t y = 0; y < kPatternHeight; ++y) {
    for (std::uint32_t x = 0; x < kPatternWidth; ++x) {
      for (const std::uint32_t channel : color_at(x, y)) image.rgba.push_back(static_cast<float>(channel) / 255.0f);
      image.rgba.push_back(1.0f);
    }
  }
  return image;
}

inline FloatImage pattern() {
  return picture_of(pattern_color);
}
inline FloatImage changed_pattern() {
  return picture_of(changed_color);
}
inline FloatImage to_linear(const FloatImage& image) {
  return mapped(image, linear_from_srgb);
}

}  // namespace velarium::image
