#pragma once

// Colours as FLIP compares them: from linear light with BT.709 primaries, 0 to 1, to an opponent space for filters and
// to L*a*b* for distances. All relative to the white of the display.

#include <array>
#include <cmath>

namespace velarium::image {

struct Rgb {
  float r, g, b;
};

namespace opponent {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix inverse(const Matrix& m) {
  const auto cofactor = [&](int row, int column) {
    const int r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  Matrix result{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result[row][column] = cofactor(column, row) / determinant;
  return result;
}

// X, Y, Z of a chromaticity, with Y = 1.
constexpr std::array<double, 3> xyz_of(double x, double y) {
  return {x / y, 1.0, (1.0 - x - y) / y};
}

// XYZ, each divided by that of white, from linear RGB: ITU-R BT.709 primaries, and D65 as (0.31271, 0.32902), CIE 15,
// 2 degree observer. Each row sums to 1.
constexpr Matrix white_relative_xyz_from_rgb() {
  const auto red = xyz_of(0.64, 0.33), green = xyz_of(0.30, 0.60), blue = xyz_of(0.15, 0.06);
  const auto white = xyz_of(0.31271, 0.32902);
  const Matrix primaries{{{red[0], green[0], blue[0]}, {red[1], green[1], blue[1]}, {red[2], green[2], blue[2]}}};
  const Matrix amounts = inverse(primaries);
  Matrix result{};
  for (int column = 0; column < 3; ++column) {
    const double amount = amounts[column][0] * white[0] + amounts[column][1] * white[1] + amounts[column][2] * white[2];
    for (int row = 0; row < 3; ++row) result[row][column] = primaries[row][column] * amount / white[row];
  }
  return result;
}

inline constexpr Matrix kXyzFromRgb = white_relative_xyz_from_rgb();
inline constexpr Matrix kRgbFromXyz = inverse(kXyzFromRgb);

template <const Matrix& kMatrix>
constexpr float row_times(int row, float a, float b, float c) {
  return static_cast<float>(kMatrix[row][0]) * a + static_cast<float>(kMatrix[row][1]) * b +
         static_cast<float>(kMatrix[row][2]) * c;
}

}  // namespace opponent

// FLIP's YCxCz without its scale and offset, with which normalised filters commute: luminance, red-green, blue-yellow.
struct Opponent {
  float y, x_minus_y, y_minus_z;
};

[[nodiscard]] inline Opponent opponent_from_rgb(const Rgb& c) {
  using opponent::kXyzFromRgb;
  const float x = opponent::row_times<kXyzFromRgb>(0, c.r, c.g, c.b);
  const float y = opponent::row_times<kXyzFromRgb>(1, c.r, c.g, c.b);
  const float z = opponent::row_times<kXyzFromRgb>(2, c.r, c.g, c.b);
  return {y, x - y, y - z};
}

[[nodiscard]] inline Rgb rgb_from_opponent(const Opponent& o) {
  using opponent::kRgbFromXyz;
  const float x = o.y + o.x_minus_y, z = o.y - o.y_minus_z;
  return {opponent::row_times<kRgbFromXyz>(0, x, o.y, z), opponent::row_times<kRgbFromXyz>(1, x, o.y, z),
          opponent::row_times<kRgbFromXyz>(2, x, o.y, z)};
}

struct Lab {
  float l, a, b;  // l from 0 to 100
};

inline constexpr float kLabKnee = 6.0f / 29.0f;  // CIE 15: where the cube root of L*a*b* becomes a line

[[nodiscard]] inline Rgb rgb_from_lab(const Lab& lab) {
  const auto cube = [](float f) { return f > kLabKnee ? f * f * f : 3.0f * kLabKnee * kLabKnee * (f - 4.0f / 29.0f); };
  const float f = (lab.l + 16.0f) / 116.0f;
  const float x = cube(f + lab.a / 500.0f), y = cube(f), z = cube(f - lab.b / 200.0f);
  return rgb_from_opponent({y, x - y, y - z});
}

// CIE L*a*b* (CIE 15), its chroma scaled by lightness (the Hunt effect, FLIP section 4.1): dark colours look less
// colourful. Precondition: components are not negative.
[[nodiscard]] inline Lab hunt_lab_from_rgb(const Rgb& c) {
  const auto f = [](float t) {
    return t > kLabKnee * kLabKnee * kLabKnee ? std::cbrt(t) : t / (3.0f * kLabKnee * kLabKnee) + 4.0f / 29.0f;
  };
  const Opponent o = opponent_from_rgb(c);
  const float fx = f(o.y + o.x_minus_y), fy = f(o.y), fz = f(o.y - o.y_minus_z);
  const float l = 116.0f * fy - 16.0f;
  return {l, 0.01f * l * 500.0f * (fx - fy), 0.01f * l * 200.0f * (fy - fz)};
}

}  // namespace velarium::image
