#include "bake/environment_texels.hpp"

#include <glm/gtc/packing.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace velarium::bake {
namespace {

TEST(HalfFromFloat, EveryHalfIsItself) {
  for (std::uint32_t bits = 0; bits <= 0x7bff; ++bits)
    ASSERT_EQ(half_from_float(glm::unpackHalf1x16(static_cast<std::uint16_t>(bits))), bits);
}

TEST(HalfFromFloat, RoundsToTheNearestEven) {
  for (std::uint32_t bits = 0; bits < 0x7bff; ++bits) {
    const float low = glm::unpackHalf1x16(static_cast<std::uint16_t>(bits));
    const float high = glm::unpackHalf1x16(static_cast<std::uint16_t>(bits + 1));
    const float middle = 0.5f * (low + high);
    ASSERT_EQ(half_from_float(middle), bits % 2 == 0 ? bits : bits + 1);
    ASSERT_EQ(half_from_float(std::nextafter(middle, high)), bits + 1);
    ASSERT_EQ(half_from_float(std::nextafter(middle, low)), bits);
  }
}

TEST(HalfMips, HaveEveryMipDownToOnePixel) {
  const image::FloatImage image{.width = 5, .height = 3, .rgba = std::vector<float>(60, 0.5f)};
  const auto halves = half_mips(image);
  ASSERT_EQ(halves.size(), 4u * (5 * 3 + 2 * 1 + 1 * 1));
  for (std::size_t i = 0; i < halves.size(); ++i) EXPECT_EQ(halves[i], i % 4 == 3 ? 0x3c00 : 0x3800) << i;
}

TEST(HalfMips, ClampToTheLargestHalf) {
  const image::FloatImage image{.width = 1, .height = 1, .rgba = {1e9f, 65504.0f, 0.0f, 1.0f}};
  EXPECT_EQ(half_mips(image), (std::vector<std::uint16_t>{0x7bff, 0x7bff, 0, 0x3c00}));
}

TEST(HalfMips, ASmallLampKeepsItsPower) {
  // Solid angle of the last but one mip's halves is equal, so it holds the mean of each side of the equator.
  image::FloatImage image{.width = 64, .height = 32, .rgba = std::vector<float>(4 * 64 * 32, 0.0f)};
  const std::uint32_t row = 5;
  image.rgba[4 * (row * 64 + 40)] = 1000.0f;
  const double step = std::acos(-1.0) / 32;
  const double part = (std::cos(row * step) - std::cos((row + 1) * step)) / 64;  // of a hemisphere's solid angle
  const auto halves = half_mips(image);
  const std::size_t last_but_one = halves.size() - 4 - 4 * 2;  // 2 x 1 pixels: left and right
  EXPECT_NEAR(glm::unpackHalf1x16(halves[last_but_one + 4]), 1000.0 * part, 0.01 * 1000.0 * part);
  EXPECT_EQ(halves[last_but_one], 0);
  EXPECT_NEAR(glm::unpackHalf1x16(halves[halves.size() - 4]), 1000.0 * part / 2, 0.01 * 1000.0 * part);
}

}  // namespace
}  // namespace velarium::bake
