#include "upload/normal_mips.hpp"

#include "shading/host.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

namespace velarium::upload {
namespace {

using Texel = std::array<std::uint8_t, 4>;

// All levels of a square picture, each row followed by bytes that nobody may touch.
class Chain {
 public:
  Chain(std::uint32_t width, std::uint32_t height, const std::function<Texel(std::uint32_t, std::uint32_t)>& texel) {
    for (std::uint32_t w = width, h = height;; w = std::max(w / 2, 1u), h = std::max(h / 2, 1u)) {
      const std::size_t pitch = std::size_t{4} * w + 8;
      bytes_.emplace_back(pitch * h, kGap);
      levels.push_back({bytes_.back().data(), pitch, w, h});
      if (w == 1 && h == 1) break;
    }
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x)
        std::memcpy(levels[0].first + y * levels[0].pitch + 4 * x, texel(x, y).data(), 4);
    make_normal_mips(levels);
  }
  [[nodiscard]] Texel get(std::size_t level, std::uint32_t x, std::uint32_t y) const {
    Texel texel;
    std::memcpy(texel.data(), levels[level].first + y * levels[level].pitch + 4 * x, 4);
    return texel;
  }
  [[nodiscard]] float spread(std::size_t level, std::uint32_t x, std::uint32_t y) const {
    return static_cast<float>(get(level, x, y)[3]) / 255.0f;
  }
  [[nodiscard]] bool gaps_are_whole() const {
    for (std::size_t i = 0; i < levels.size(); ++i)
      for (std::uint32_t y = 0; y < levels[i].height; ++y)
        for (std::size_t b = 4 * levels[i].width; b < levels[i].pitch; ++b)
          if (levels[i].first[y * levels[i].pitch + b] != kGap) return false;
    return true;
  }
  std::vector<TexelRows> levels;

 private:
  static constexpr std::byte kGap{0x5a};
  std::vector<std::vector<std::byte>> bytes_;
};

glm::dvec3 decoded(const Texel& texel) {
  return glm::normalize(glm::dvec3(texel[0], texel[1], texel[2]) * 2.0 - 255.0);
}

Texel encoded(const glm::dvec3& n) {
  const glm::dvec3 codes = glm::floor(glm::normalize(n) * 127.5 + 128.0);
  return {static_cast<std::uint8_t>(codes.x), static_cast<std::uint8_t>(codes.y), static_cast<std::uint8_t>(codes.z),
          0};
}

// Slopes without a pattern, deviation 0.2 along each axis.
Texel bump(std::uint32_t x, std::uint32_t y) {
  std::mt19937 random(1000 * x + y);
  const auto slope = [&] {
    double sum = 0.0;  // of 12 even numbers: variance 1
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random() >> 8) / 16777216.0;
    return 0.2 * (sum - 6.0);
  };
  const double dx = slope(), dy = slope();
  return encoded({-dx, -dy, 1.0});
}

// Of all texels of level 0 under one of another level, in double.
struct Mean {
  glm::dvec3 direction;
  double length;
};

Mean mean_below(const Chain& chain, std::size_t level, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t size = 1u << level;
  glm::dvec3 sum(0.0);
  for (std::uint32_t j = 0; j < size; ++j)
    for (std::uint32_t i = 0; i < size; ++i) sum += decoded(chain.get(0, size * x + i, size * y + j));
  return {glm::normalize(sum), glm::length(sum) / (size * size)};
}

TEST(NormalMips, FlatMapsHaveNoSpread) {
  const Texel flat{128, 128, 255, 0}, tilted = encoded({0.3, -0.2, 0.9});
  for (const Texel& texel : {flat, tilted}) {
    const Chain chain(16, 8, [&](auto, auto) { return texel; });
    for (std::size_t level = 1; level < chain.levels.size(); ++level) {
      EXPECT_EQ(chain.get(level, 0, 0)[3], 0) << level;
      EXPECT_GT(glm::dot(decoded(chain.get(level, 0, 0)), decoded(texel)), 0.99998) << level;
    }
  }
}

// |n| of 8-bit normals differs by 0.3 %: lengths alone must not read as spread.
TEST(NormalMips, LengthsOfTexelsDoNotCount) {
  const Chain chain(8, 8, [](std::uint32_t x, std::uint32_t y) {
    const double length = 0.6 + 0.05 * static_cast<double>((x + y) % 8);
    const auto code = static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * length));
    return Texel{127, 128, code, 0};
  });
  // Half a code of x and y over at least 0.6 is 0.007: what is left is the spread of the codes themselves.
  EXPECT_LE(chain.spread(1, 0, 0), 0.008f);
}

TEST(NormalMips, AreThoseOfAllTexelsBelow) {
  const Chain chain(64, 64, bump);
  for (const std::size_t level : {1u, 2u, 4u, 6u}) {
    const std::uint32_t last = (64u >> level) - 1;
    for (const std::uint32_t place : {0u, last}) {
      const Mean truth = mean_below(chain, level, place, last - place);
      const Texel texel = chain.get(level, place, last - place);
      EXPECT_GT(glm::dot(decoded(texel), truth.direction), 0.99997) << level;
      EXPECT_NEAR(chain.spread(level, place, last - place), std::sqrt(2.0 * (1.0 - truth.length) / truth.length),
                  0.5 / 255.0 + 1e-4)
          << level;
    }
  }
  // (1 - r) / r is 0.0373 for slopes of deviation 0.2: the spread is its double's root.
  EXPECT_NEAR(chain.spread(6, 0, 0), std::sqrt(2.0 * 0.0373), 0.01);
}

// Half the texels lean by 45 degrees to one side, half to the other: r = cos 45, 2 (1 - r) / r = 0.828.
TEST(NormalMips, OpposedSlopesSpreadFar) {
  const Chain chain(4, 4, [](std::uint32_t x, std::uint32_t) { return encoded({x % 2 == 0 ? 1.0 : -1.0, 0.0, 1.0}); });
  EXPECT_NEAR(chain.spread(1, 0, 0), std::sqrt(0.828), 0.01);
  EXPECT_NEAR(chain.spread(2, 0, 0), std::sqrt(0.828), 0.01);
  EXPECT_EQ(chain.get(2, 0, 0)[2], 255);
}

TEST(NormalMips, OddSizesAndNarrowOnesReachTheLastTexel) {
  for (const auto& [width, height] : {std::pair{37u, 11u}, std::pair{1u, 9u}, std::pair{5u, 1u}, std::pair{1u, 1u}}) {
    const Chain chain(width, height, bump);
    const auto& last = chain.levels.back();
    EXPECT_EQ(last.width * last.height, 1u);
    EXPECT_GT(decoded(chain.get(chain.levels.size() - 1, 0, 0)).z, 0.8);
    EXPECT_TRUE(chain.gaps_are_whole());
  }
}

TEST(NormalMips, LevelZeroHasNoAlpha) {
  const std::array<std::byte, 8> from{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4},
                                      std::byte{5}, std::byte{6}, std::byte{7}, std::byte{255}};
  std::array<std::byte, 8> to{};
  copy_without_alpha(from, to.data());
  const std::array<std::byte, 8> expected{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{0},
                                          std::byte{5}, std::byte{6}, std::byte{7}, std::byte{0}};
  EXPECT_EQ(to, expected);
}

}  // namespace
}  // namespace velarium::upload
