// The sequence's two promises: within a draw points are spread as evenly as can be; between draws, pixels and seeds
// they have nothing to do with each other.

#include "reference/sequence.hpp"
#include "statistical/chi_squared.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace velarium::statistical {
namespace {

using glm::uvec2;
using reference::Sequence;

// The numbers of one draw, a 2D one unless it is odd.
vec2 draw(uvec2 pixel, std::uint32_t sample, std::uint32_t seed, int number) {
  Sequence sequence(pixel, sample, seed);
  vec2 result(0.0f);
  for (int i = 0; i <= number; ++i) result = i % 2 == 0 ? sequence.next_2d() : vec2(sequence.next_1d(), 0.0f);
  return result;
}

constexpr float kStep = 1.0f / 16777216.0f;

// By another program, from the papers: bit by bit, the second dimension from the recurrence of its direction numbers.
TEST(Sequence, IsTheSameEverywhere) {
  EXPECT_EQ(draw({0, 0}, 0, 0, 0), vec2(9362523.0f, 10401470.0f) * kStep);
  EXPECT_EQ(draw({0, 0}, 0, 0, 1).x, 8894199.0f * kStep);
  EXPECT_EQ(draw({0, 0}, 0, 0, 2), vec2(15918232.0f, 7784638.0f) * kStep);
  EXPECT_EQ(draw({3, 7}, 5, 1, 0), vec2(12613325.0f, 8767162.0f) * kStep);
  EXPECT_EQ(draw({1919, 1079}, 4095, 12345, 1).x, 15463799.0f * kStep);
  EXPECT_EQ(draw({1919, 1079}, 4095, 12345, 2), vec2(7547258.0f, 13571278.0f) * kStep);
}

// m_k = 2 m_(k-1) xor m_(k-1), the recurrence of the primitive polynomial x + 1 [Bratley & Fox 1988].
TEST(Sequence, SecondDimensionFollowsItsPolynomial) {
  std::uint32_t direction = 1;
  for (std::uint32_t k = 0; k < 32; ++k) {
    EXPECT_EQ(shading::reverse_bits(shading::sobol_second_dimension(1u << k)), direction << (31u - k)) << k;
    direction ^= 2u * direction;
  }
}

// One point in each of 2^k intervals of 2^-k: every shape of them, and every aligned block of 2^k points.
TEST(Sequence, FillsElementaryIntervals) {
  for (const std::uint32_t seed : {0u, 1u, 77u}) {
    for (const uvec2 pixel : {uvec2(0, 0), uvec2(500, 3)}) {
      for (std::uint32_t k = 0; k <= 10; ++k) {
        for (const std::uint32_t first : {0u, 1u << k, 5u << k}) {
          std::vector<vec2> points;
          for (std::uint32_t i = 0; i < 1u << k; ++i) points.push_back(draw(pixel, first + i, seed, 2));
          for (std::uint32_t bits = 0; bits <= k; ++bits) {
            const float columns = static_cast<float>(1u << bits), rows = static_cast<float>(1u << (k - bits));
            std::set<std::pair<int, int>> cells;
            for (const vec2& p : points) cells.emplace(static_cast<int>(p.x * columns), static_cast<int>(p.y * rows));
            ASSERT_EQ(cells.size(), points.size()) << "2^" << bits << " columns, 2^" << k - bits << " rows";
          }
        }
      }
    }
  }
}

TEST(Sequence, FillsIntervalsOfTheLine) {
  for (std::uint32_t k = 0; k <= 12; ++k) {
    std::set<int> cells;
    for (std::uint32_t i = 0; i < 1u << k; ++i)
      cells.insert(static_cast<int>(draw({9, 9}, (3u << k) + i, 4, 1).x * static_cast<float>(1u << k)));
    EXPECT_EQ(cells.size(), std::size_t{1} << k);
  }
}

// The largest difference between the area of a box at the origin and its share of the points. It is taken, or
// approached, where each side goes through a point or is 1.
double star_discrepancy(std::vector<vec2> points) {
  std::sort(points.begin(), points.end(), [](const vec2& a, const vec2& b) { return a.x < b.x; });
  std::vector<float> heights{1.0f};
  for (const vec2& p : points) heights.push_back(p.y);
  const double n = static_cast<double>(points.size());
  double worst = 0.0;
  for (const float height : heights) {
    double open = 0.0, closed = 0.0;  // points in the boxes without and with their upper sides
    for (const vec2& p : points) {
      worst = std::max(worst, double{p.x} * height - open / n);
      open += p.y < height ? 1.0 : 0.0;
      closed += p.y <= height ? 1.0 : 0.0;
      worst = std::max(worst, closed / n - double{p.x} * height);
    }
    worst = std::max(worst, height - open / n);
  }
  return worst;
}

// For 2^m points that fill all elementary intervals: at most floor(m/2 + 3/2) / 2^m [Niederreiter 1992, theorem 4.6].
// Random points go as 1 / sqrt(n): at n = 256 the bound is 5 / 256 = 0.020, and they have some 0.07.
TEST(Sequence, HasLowDiscrepancy) {
  Random random(1);
  double random_mean = 0.0;
  constexpr int kRounds = 16;
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    std::vector<vec2> points, random_points;
    for (std::uint32_t i = 0; i < 256; ++i) {
      points.push_back(draw({round, 0}, i, 0, 0));
      random_points.push_back({random.uniform(), random.uniform()});
    }
    EXPECT_LE(star_discrepancy(points), 5.0 / 256.0);
    random_mean += star_discrepancy(random_points) / kRounds;
  }
  EXPECT_GT(random_mean, 0.05);
}

TEST(Sequence, DiscrepancyOfKnownPoints) {
  EXPECT_NEAR(star_discrepancy({vec2(0.5f)}), 0.75, 1e-9);  // the closed box up to the point
  EXPECT_NEAR(star_discrepancy({vec2(0.0f)}), 1.0, 1e-9);
}

// Pairs of numbers that should be free of each other, counted on a grid over all pixels of a picture.
using Pair = std::function<vec2(uvec2 pixel)>;
constexpr std::uint32_t kCells = 16;

Verdict test_pairs(const Pair& pair) {
  constexpr std::uint32_t kPicture = 128;
  std::vector<double> observed(kCells * kCells), expected(kCells * kCells);
  for (std::uint32_t i = 0; i < kPicture * kPicture; ++i) {
    const vec2 cell = pair({i % kPicture, i / kPicture}) * static_cast<float>(kCells);
    ++observed[static_cast<std::size_t>(cell.y) * kCells + static_cast<std::size_t>(cell.x)];
  }
  std::fill(expected.begin(), expected.end(), 1.0 * kPicture * kPicture / (kCells * kCells));
  return compare_counts(observed, expected);
}

TEST(Sequence, PixelsAreIndependent) {
  for (const std::uint32_t sample : {0u, 1u, 63u}) {
    for (const uvec2 step : {uvec2(1, 0), uvec2(0, 1), uvec2(1, 1), uvec2(8, 0), uvec2(0, 64)}) {
      const auto pair = [&](uvec2 pixel) {
        return vec2(draw(pixel, sample, 0, 0).x, draw(pixel + step, sample, 0, 0).x);
      };
      EXPECT_TRUE(agrees(test_pairs(pair), 15)) << sample << ' ' << step.x << ' ' << step.y;
    }
  }
}

TEST(Sequence, SeedsAreIndependent) {
  for (const std::uint32_t seed : {1u, 2u, 1u << 31}) {
    const auto pair = [&](uvec2 pixel) { return vec2(draw(pixel, 0, 0, 0).y, draw(pixel, 0, seed, 0).y); };
    EXPECT_TRUE(agrees(test_pairs(pair), 3)) << seed;
  }
}

TEST(Sequence, DrawsAreIndependent) {
  for (const std::uint32_t sample : {0u, 2u}) {
    for (const int a : {0, 1, 4}) {
      for (const int b : {2, 5, 12}) {
        const auto pair = [&](uvec2 pixel) { return vec2(draw(pixel, sample, 0, a).x, draw(pixel, sample, 0, b).x); };
        EXPECT_TRUE(agrees(test_pairs(pair), 18)) << sample << ' ' << a << ' ' << b;
      }
    }
  }
}

TEST(Sequence, CoordinatesOfAPointAreIndependent) {
  for (const std::uint32_t sample : {0u, 1u, 1000u})
    EXPECT_TRUE(agrees(test_pairs([&](uvec2 pixel) { return draw(pixel, sample, 0, 0); }), 3)) << sample;
}

// Owen scrambling gives each half of an interval a scrambling of its own: of two points that part at the first bit, all
// further bits are independent.
TEST(Sequence, HalvesAreScrambledApart) {
  for (const uvec2 samples : {uvec2(0, 1), uvec2(2, 3), uvec2(100, 101), uvec2(4094, 4095)}) {
    for (const int axis : {0, 1}) {
      const auto pair = [&](uvec2 pixel) {
        const vec2 both(draw(pixel, samples.x, 0, 0)[axis], draw(pixel, samples.y, 0, 0)[axis]);
        EXPECT_NE(both.x < 0.5f, both.y < 0.5f);
        return glm::fract(2.0f * both);
      };
      EXPECT_TRUE(agrees(test_pairs(pair), 8)) << samples.x << ' ' << axis;
    }
  }
}

// Within one pixel two draws must not walk in step. 16 consecutive samples share their fate; one out of each 16 is as
// good as random on a grid of 16 x 16.
TEST(Sequence, DrawsOfOnePixelAreIndependent) {
  for (const uvec2 pixel : {uvec2(0, 0), uvec2(1, 0), uvec2(640, 360), uvec2(1279, 719)}) {
    for (const int other : {1, 2, 6}) {
      const auto pair = [&](uvec2 place) {
        const std::uint32_t sample = kCells * (128 * place.y + place.x);
        return vec2(draw(pixel, sample, 0, 0).x, draw(pixel, sample, 0, other).x);
      };
      EXPECT_TRUE(agrees(test_pairs(pair), 12)) << pixel.x << ' ' << other;
    }
  }
}

}  // namespace
}  // namespace velarium::statistical
