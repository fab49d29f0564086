#include "bake/normal_lengths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "unit/shading/support.hpp"

namespace velarium::bake {
namespace {

using namespace shading;

int length_at(const std::vector<std::uint8_t>& table, std::uint32_t size, const vec3& n) {
  const vec2 texel = bfn_table_texel(n, static_cast<float>(size));
  return table[static_cast<std::size_t>(texel.y) * size + static_cast<std::size_t>(texel.x)];
}

struct Errors {
  double mean = 0, rms = 0, max = 0;  // degrees
};

Errors encoding_errors(std::uint32_t size) {
  const std::vector<std::uint8_t> table = best_fit_normal_lengths(size);
  Random random(3);
  Errors e;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const vec3 n = random.direction();
    const float value = static_cast<float>(length_at(table, size, n)) / 255.0f;
    const double error = angle_degrees(n, bfn_decode(unorm8(bfn_encode(n, value))));
    e.mean += error / kCount;
    e.rms += error * error / kCount;
    e.max = std::max(e.max, error);
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

// The figures are those of a search written apart from this code, in double.
TEST(NormalLengths, ErrorsAreThoseOfTheSize) {
  const struct {
    std::uint32_t size;
    double mean, rms;
  } rows[] = {{1024, 0.0325, 0.0403}, {512, 0.0383, 0.0459}, {256, 0.0557, 0.0633}, {128, 0.0995, 0.1094}};
  for (const auto& row : rows) {
    const Errors e = encoding_errors(row.size);
    EXPECT_NEAR(e.mean, row.mean, 0.01 * row.mean) << row.size;
    EXPECT_NEAR(e.rms, row.rms, 0.01 * row.rms) << row.size;
    EXPECT_LT(e.max, 0.36) << row.size;
  }
}

// Odd integers up to 255, which hold no axis, had means of 0.0394 and 0.0461 degrees at the size that is drawn with.
TEST(NormalLengths, ErrNoMoreThanThoseOfALatticeWithoutAxes) {
  const Errors e = encoding_errors(512);
  EXPECT_LT(e.mean, 0.0394);
  EXPECT_LT(e.rms, 0.0461);
}

double error_with_length(const vec3& n, int k) {
  return angle_degrees(n, bfn_decode(unorm8(bfn_encode(n, static_cast<float>(k) / 255.0f))));
}

// The lengths may differ where two err alike to within fp32; the errors may not.
TEST(NormalLengths, AreAsGoodAsTheSearchInDouble) {
  constexpr std::uint32_t kSize = 256;
  const std::vector<std::uint8_t> table = best_fit_normal_lengths(kSize);
  for (std::uint32_t y = 0; y < kSize; y += 5) {
    for (std::uint32_t x = 0; x < kSize; x += 3) {
      const vec3 n = bfn_table_direction(vec2(x, y) + vec2(0.5f), kSize);
      const double best = error_with_length(n, best_fit_length(n));
      ASSERT_NEAR(error_with_length(n, table[y * kSize + x]), best, 1e-5 + 1e-4 * best) << x << ' ' << y;
    }
  }
}

TEST(NormalLengths, AreIntegersOfTheLattice) {
  for (const std::uint32_t size : {2u, 7u, 64u}) {
    const std::vector<std::uint8_t> table = best_fit_normal_lengths(size);
    ASSERT_EQ(table.size(), std::size_t{size} * size);
    EXPECT_TRUE(std::all_of(table.begin(), table.end(), [](std::uint8_t k) { return k >= 1 && k <= 127; }));
  }
}

// Directions of texels that hold nothing else: axes, and halfway between two.
TEST(NormalLengths, AreTheLargestOfEqualOnes) {
  const std::vector<std::uint8_t> table = best_fit_normal_lengths(512);
  EXPECT_EQ(length_at(table, 512, vec3(0.0f, -1.0f, 0.0f)), 127);
  EXPECT_EQ(length_at(table, 512, vec3(1.0f, 0.0f, -1.0f)), 127);
}

TEST(NormalLengths, AxesAreExact) {
  const std::vector<std::uint8_t> table = best_fit_normal_lengths(512);
  for (const vec3 n : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(-1, 0, 0), vec3(0, -1, 0), vec3(0, 0, -1)}) {
    const float value = static_cast<float>(length_at(table, 512, n)) / 255.0f;
    EXPECT_EQ(bfn_decode(unorm8(bfn_encode(n, value))), n);
  }
}

}  // namespace
}  // namespace velarium::bake
