#include "upload/mips.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace velarium::upload {
namespace {

using Texel = std::array<std::uint8_t, 4>;

// Rows of 8-bit RGBA with bytes between them, which nobody may touch.
class Level {
 public:
  Level(std::uint32_t width, std::uint32_t height) : width_(width), height_(height), bytes_(pitch() * height, kGap) {}

  [[nodiscard]] TexelRows rows() { return {bytes_.data(), pitch(), width_, height_}; }
  void set(std::uint32_t x, std::uint32_t y, const Texel& texel) {
    for (std::size_t c = 0; c < 4; ++c) bytes_[pitch() * y + 4 * x + c] = static_cast<std::byte>(texel[c]);
  }
  [[nodiscard]] Texel get(std::uint32_t x, std::uint32_t y) const {
    Texel texel;
    for (std::size_t c = 0; c < 4; ++c) texel[c] = static_cast<std::uint8_t>(bytes_[pitch() * y + 4 * x + c]);
    return texel;
  }
  [[nodiscard]] bool gaps_are_whole() const {
    for (std::uint32_t y = 0; y < height_; ++y)
      for (std::size_t i = 4 * width_; i < pitch(); ++i)
        if (bytes_[pitch() * y + i] != kGap) return false;
    return true;
  }

 private:
  static constexpr std::byte kGap{0xa5};
  [[nodiscard]] std::size_t pitch() const { return 4 * width_ + 12; }
  std::uint32_t width_, height_;
  std::vector<std::byte> bytes_;
};

Texel half(const std::array<Texel, 4>& texels, bool srgb) {
  Level from(2, 2), to(1, 1);
  for (std::uint32_t i = 0; i < 4; ++i) from.set(i % 2, i / 2, texels[i]);
  make_mip(from.rows(), to.rows(), srgb);
  return to.get(0, 0);
}

TEST(Mips, FlatColoursStayWhatTheyAre) {
  for (const bool srgb : {false, true}) {
    for (int value = 0; value < 256; ++value) {
      const auto v = static_cast<std::uint8_t>(value), w = static_cast<std::uint8_t>(255 - value);
      const Texel texel{v, w, v, w};
      EXPECT_EQ(half({texel, texel, texel, texel}, srgb), texel) << value;
      Level from(5, 3), to(2, 1);
      for (std::uint32_t i = 0; i < 15; ++i) from.set(i % 5, i / 5, texel);
      make_mip(from.rows(), to.rows(), srgb);
      EXPECT_EQ(to.get(0, 0), texel) << value;
      EXPECT_EQ(to.get(1, 0), texel) << value;
    }
  }
}

// Half of the light of white is encoded as 0.7354 (IEC 61966-2-1: 1.055 * 0.5^(1/2.4) - 0.055), 187.5 of 255; a quarter
// as 0.5371, 136.96. Alpha is no light: half of it is 127.5, which goes to the even code.
TEST(Mips, ColoursAreAveragedAsLightAndAlphaIsNot) {
  const Texel white{255, 255, 255, 255}, black{0, 0, 0, 0};
  const Texel quarter = half({white, black, black, black}, true);
  EXPECT_EQ(quarter, (Texel{137, 137, 137, 64}));
  const Texel two = half({white, black, black, white}, true);
  EXPECT_TRUE(two[0] == 187 || two[0] == 188) << int{two[0]};
  EXPECT_EQ(two[3], 128);
  EXPECT_EQ(half({white, black, black, black}, false), (Texel{64, 64, 64, 64}));
}

TEST(Mips, HalfWayCasesGoToTheEvenCode) {
  const auto mean = [](std::uint8_t a, std::uint8_t b) {
    return half({Texel{a, a, a, a}, Texel{a, a, a, a}, Texel{b, b, b, b}, Texel{b, b, b, b}}, false)[0];
  };
  EXPECT_EQ(mean(0, 1), 0);
  EXPECT_EQ(mean(1, 2), 2);
  EXPECT_EQ(mean(2, 3), 2);
  EXPECT_EQ(mean(254, 255), 254);
}

// Five texels become two: their centres lie at 0.75 and 3.25 (Vulkan: (i + 0.5) * 5 / 2 - 0.5).
TEST(Mips, OddSizesAreReadAroundTheCentre) {
  Level from(5, 1), to(2, 1);
  constexpr std::array<std::uint8_t, 5> kValues{10, 50, 200, 100, 20};
  for (std::uint32_t x = 0; x < 5; ++x) from.set(x, 0, {kValues[x], 0, 0, 255});
  make_mip(from.rows(), to.rows(), false);
  EXPECT_EQ(to.get(0, 0)[0], 40);  // 10 / 4 + 50 * 3 / 4
  EXPECT_EQ(to.get(1, 0)[0], 80);  // 100 * 3 / 4 + 20 / 4
}

TEST(Mips, RowsEndWhereTheyEnd) {
  Level from(6, 7), to(3, 3);
  for (std::uint32_t i = 0; i < 42; ++i) from.set(i % 6, i / 6, {1, 2, 3, 4});
  make_mip(from.rows(), to.rows(), false);
  EXPECT_TRUE(to.gaps_are_whole());
  EXPECT_EQ(to.get(2, 2), (Texel{1, 2, 3, 4}));
}

}  // namespace
}  // namespace velarium::upload
