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

// Of what is seen of level 0 under a texel of another level, in double.
struct Mean {
  glm::dvec3 direction;
  double length;
};

// Four texels, and what a filter shows between them: three tenths of what their mean length lacks to 1.
glm::dvec3 block_mean(const Chain& chain, std::uint32_t x, std::uint32_t y) {
  glm::dvec3 sum(0.0);
  for (std::uint32_t i = 0; i < 4; ++i) sum += decoded(chain.get(0, 2 * x + i % 2, 2 * y + i / 2));
  const double r = 0.25 * glm::length(sum);
  return glm::normalize(sum) * (1.0 - 0.3 * (1.0 - r));
}

Mean mean_below(const Chain& chain, std::size_t level, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t size = 1u << (level - 1);
  glm::dvec3 sum(0.0);
  for (std::uint32_t j = 0; j < size; ++j)
    for (std::uint32_t i = 0; i < size; ++i) sum += block_mean(chain, size * x + i, size * y + j);
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

// What level `level` shows of the block of two by two that a texel is in, over what the block has.
double block_gap(const Chain& chain, std::size_t level, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t last = (64u >> level) - 1;
  glm::dvec3 sum(0.0);
  for (std::uint32_t i = 0; i < 4; ++i)
    sum += mean_below(chain, level, std::min(x - x % 2 + i % 2, last), std::min(y - y % 2 + i / 2, last)).direction;
  const double r = 0.25 * glm::length(sum);
  return r / (1.0 - 0.3 * (1.0 - r));
}

TEST(NormalMips, AreThoseOfAllTexelsBelow) {
  const Chain chain(64, 64, bump);
  for (const std::size_t level : {1u, 2u, 4u, 6u}) {
    const std::uint32_t last = (64u >> level) - 1;
    for (const std::uint32_t place : {0u, last}) {
      const Mean truth = mean_below(chain, level, place, last - place);
      const Texel texel = chain.get(level, place, last - place);
      EXPECT_GT(glm::dot(decoded(texel), truth.direction), 0.99997) << level;
      const double r = truth.length * block_gap(chain, level, place, last - place);
      EXPECT_NEAR(chain.spread(level, place, last - place), std::sqrt(2.0 * (1.0 - r) / r), 0.5 / 255.0 + 1e-4)
          << level;
    }
  }
}

// Of slopes without a pattern a bilinear filter shows 4/9 of the variance: 2/3 along each axis. (1 - r) / r is 0.0171
// for Gaussian slopes whose deviation is 2/3 of 0.2.
TEST(NormalMips, SpreadIsWhatFiltersShow) {
  const Chain chain(64, 64, bump);
  EXPECT_NEAR(chain.spread(6, 0, 0), std::sqrt(2.0 * 0.0171), 0.005);
}

// Ripples that are longer than texels: whole periods on a tile.
Texel ripple(std::uint32_t x, std::uint32_t y) {
  const double u = glm::radians(360.0 / 64.0) * x, v = glm::radians(360.0 / 64.0) * y;
  return encoded({0.1 * std::cos(3.0 * u + v), 0.1 * std::cos(2.0 * u - 5.0 * v), 1.0});
}

// Mean of the squares of all slopes that a bilinear filter shows of a level, and of their spread.
double shown_variance(const Chain& chain, std::size_t level) {
  constexpr std::uint32_t kSteps = 4;  // between two texels
  const std::uint32_t size = 64u >> level, points = size * kSteps;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < points * points; ++i) {
    const std::uint32_t x = i % points, y = i / points, x0 = x / kSteps, y0 = y / kSteps;
    const std::uint32_t x1 = (x0 + 1) % size, y1 = (y0 + 1) % size;
    const double fx = (x % kSteps + 0.5) / kSteps, fy = (y % kSteps + 0.5) / kSteps;
    const auto filtered = [&](const auto& read) {
      return glm::mix(glm::mix(read(x0, y0), read(x1, y0), fx), glm::mix(read(x0, y1), read(x1, y1), fx), fy);
    };
    const glm::dvec3 n = filtered([&](std::uint32_t a, std::uint32_t b) { return decoded(chain.get(level, a, b)); });
    const double spread =
        filtered([&](std::uint32_t a, std::uint32_t b) { return static_cast<double>(chain.spread(level, a, b)); });
    sum += (n.x * n.x + n.y * n.y) / (n.z * n.z) + spread * spread;
  }
  return sum / (points * points);
}

// Normals and spread hold together what the full size shows, at each level: 0.1^2 / 2 along each axis.
TEST(NormalMips, EachLevelHoldsAllOfTheVariance) {
  const Chain chain(64, 64, ripple);
  EXPECT_NEAR(shown_variance(chain, 0), 0.01, 0.0003);
  for (std::size_t level = 1; level < chain.levels.size(); ++level)
    EXPECT_NEAR(shown_variance(chain, level), 0.01, 0.0008) << level;
}

// Columns lean by 20 degrees to one side and to the other. Between them slopes are as frequent from -tan 20 to tan 20:
// r = asinh(tan 20) / tan 20 = 0.9785, 2 (1 - r) / r = 0.0439.
TEST(NormalMips, OpposedSlopesSpread) {
  const double slope = std::tan(glm::radians(20.0));
  const Chain chain(4, 4, [&](std::uint32_t x, std::uint32_t) {
    return encoded({x % 2 == 0 ? slope : -slope, 0.0, 1.0});
  });
  EXPECT_NEAR(chain.spread(1, 0, 0), std::sqrt(0.0439), 0.02);
  EXPECT_NEAR(chain.spread(2, 0, 0), std::sqrt(0.0439), 0.02);
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
