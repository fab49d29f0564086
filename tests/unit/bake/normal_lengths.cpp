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

// What a nearest-filtered, clamped read of the table gives.
int length_at(const std::vector<std::uint8_t>& table, std::uint32_t size, const vec3& n) {
  const vec2 uv = bfn_table_uv(n);
  const auto texel = [&](float t) {
    return std::min(static_cast<std::uint32_t>(t * static_cast<float>(size)), size - 1);
  };
  return table[texel(uv.y) * size + texel(uv.x)];
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

TEST(NormalLengths, ErrorsAreThoseOfTheSize) {
  const struct {
    std::uint32_t size;
    double mean, rms;
  } rows[] = {{1024, 0.0317, 0.0390}, {512, 0.0401, 0.0471}, {256, 0.0619, 0.0700}, {128, 0.1125, 0.1250}};
  for (const auto& row : rows) {
    const Errors e = encoding_errors(row.size);
    EXPECT_NEAR(e.mean, row.mean, 0.05 * row.mean) << row.size;
    EXPECT_NEAR(e.rms, row.rms, 0.05 * row.rms) << row.size;
    EXPECT_LT(e.max, 0.36) << row.size;
  }
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
      const float middle = (static_cast<float>(x) + 0.5f) / kSize, ratio = (static_cast<float>(y) + 0.5f) / kSize;
      const vec3 n{1.0f, middle, middle * ratio};
      const double best = error_with_length(n, best_fit_length(n));
      ASSERT_NEAR(error_with_length(n, table[y * kSize + x]), best, 1e-5 + 1e-4 * best) << x << ' ' << y;
    }
  }
}

TEST(NormalLengths, AreOddAndNeverNull) {
  for (const std::uint32_t size : {1u, 7u, 64u}) {
    const std::vector<std::uint8_t> table = best_fit_normal_lengths(size);
    ASSERT_EQ(table.size(), std::size_t{size} * size);
    EXPECT_TRUE(std::all_of(table.begin(), table.end(), [](std::uint8_t k) { return k % 2 == 1; }));
  }
  const std::vector<std::uint8_t> table = best_fit_normal_lengths(1024);
  EXPECT_EQ(length_at(table, 1024, vec3(1.0f, 2.0f, 3.0f)), 253);
}

}  // namespace
}  // namespace velarium::bake
