#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

vec3 through_codes(const vec3& n, int k) {
  return bfn_decode(unorm8(bfn_encode(n, static_cast<float>(k) / 255.0f)));
}

vec3 plain_codes(const vec3& n) {
  return unorm8(n * 0.5f + vec3(0.5f));
}

struct Statistics {
  double mean = 0, rms = 0, p99 = 0, max = 0;
};

Statistics error_statistics(int count, const std::function<vec3(const vec3&)>& through) {
  Random random(3);
  std::vector<double> errors;
  Statistics s;
  for (int i = 0; i < count; ++i) {
    const vec3 n = random.direction();
    errors.push_back(angle_degrees(n, through(n)));
    s.mean += errors.back() / count;
    s.rms += errors.back() * errors.back() / count;
  }
  std::sort(errors.begin(), errors.end());
  s.rms = std::sqrt(s.rms);
  s.p99 = errors[errors.size() * 99 / 100];
  s.max = errors.back();
  return s;
}

TEST(BestFitNormals, ErrorsAreThoseOfTheSearch) {
  const Statistics fit = error_statistics(100000, [](const vec3& n) { return through_codes(n, best_fit_length(n)); });
  EXPECT_NEAR(fit.mean, 0.0289, 0.05 * 0.0289);
  EXPECT_NEAR(fit.rms, 0.0363, 0.05 * 0.0363);
  EXPECT_NEAR(fit.p99, 0.114, 0.05 * 0.114);
  EXPECT_LT(fit.max, 0.318);  // that of an axis
  const Statistics plain = error_statistics(100000, [](const vec3& n) { return 2.0f * plain_codes(n) - vec3(1.0f); });
  EXPECT_NEAR(plain.mean, 0.171, 0.05 * 0.171);
  EXPECT_NEAR(plain.p99, 0.316, 0.05 * 0.316);
}

TEST(BestFitNormals, KnownDirection) {
  const vec3 n = normalize(vec3(1.0f, 2.0f, 3.0f));
  ASSERT_EQ(best_fit_length(n), 253);
  const vec3 stored = unorm8(bfn_encode(n, 253.0f / 255.0f));
  EXPECT_EQ(2 * code8(stored.x) - 255, 85);
  EXPECT_EQ(2 * code8(stored.y) - 255, 169);
  EXPECT_EQ(2 * code8(stored.z) - 255, 253);
  EXPECT_NEAR(angle_degrees(n, bfn_decode(stored)), 0.1187, 1e-4);
  EXPECT_NEAR(angle_degrees(n, 2.0f * plain_codes(n) - vec3(1.0f)), 0.1465, 1e-4);
}

TEST(BestFitNormals, AxesKeepTheErrorOfOddCodes) {
  EXPECT_NEAR(angle_degrees(vec3(0, 0, 1), through_codes(vec3(0, 0, 1), 255)), 0.318, 1e-3);
}

TEST(BestFitNormals, TableIsReadBySortedComponents) {
  for (const vec3 n : {vec3(0.2f, 0.4f, 0.8f), vec3(-0.8f, 0.2f, -0.4f), vec3(0.4f, -0.8f, 0.2f)}) {
    EXPECT_NEAR(bfn_table_uv(n).x, 0.5f, 1e-6);
    EXPECT_NEAR(bfn_table_uv(n).y, 0.5f, 1e-6);
  }
  EXPECT_EQ(bfn_table_uv(vec3(0, 1, 0)), vec2(0.0f, 0.0f));
  EXPECT_EQ(bfn_table_uv(vec3(-1, 1, 1)), vec2(1.0f, 1.0f));
}

// Codes in use over the texel directions of a cube map, 256 pixels a face: one number for each code.
std::size_t distinct_codes(const std::function<vec3(const vec3&)>& stored) {
  std::vector<std::uint32_t> codes;
  for (uint face = 0; face < 6; ++face) {
    for (int y = 0; y < 256; ++y) {
      for (int x = 0; x < 256; ++x) {
        const vec2 uv{(static_cast<float>(x) + 0.5f) / 256.0f, (static_cast<float>(y) + 0.5f) / 256.0f};
        const vec3 s = stored(cube_direction(face, uv));
        codes.push_back(static_cast<std::uint32_t>(code8(s.x) << 16 | code8(s.y) << 8 | code8(s.z)));
      }
    }
  }
  std::sort(codes.begin(), codes.end());
  return static_cast<std::size_t>(std::unique(codes.begin(), codes.end()) - codes.begin());
}

// The counts hang on ties in rounding, which fp32 breaks otherwise here and there: within 0.2 %.
TEST(BestFitNormals, UseNearlyEveryCode) {
  EXPECT_NEAR(static_cast<double>(distinct_codes(plain_codes)), 225488, 450);
  const auto fit = [](const vec3& n) { return unorm8(bfn_encode(n, static_cast<float>(best_fit_length(n)) / 255.0f)); };
  EXPECT_NEAR(static_cast<double>(distinct_codes(fit)), 390152, 780);
}

TEST(OctahedralNormals, RoundTrip) {
  Random random(4);
  for (int i = 0; i < 100000; ++i) {
    const vec3 n = random.direction();
    const vec2 p = oct_encode(n);
    ASSERT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1.0f);
    ASSERT_LT(angle_degrees(n, oct_decode(p)), 3e-5);
  }
  for (const vec3 axis : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(0, -1, 0)}) {
    EXPECT_LT(length(oct_decode(oct_encode(axis)) - axis), 1e-6f);
  }
}

TEST(OctahedralNormals, ErrorsOfTwelveBits) {
  const auto quantised = [](const vec3& n) {
    const vec2 p = oct_encode(n);
    const auto q = [](float v) { return std::floor((0.5f * v + 0.5f) * 4095.0f + 0.5f) / 4095.0f * 2.0f - 1.0f; };
    return oct_decode({q(p.x), q(p.y)});
  };
  const Statistics s = error_statistics(100000, quantised);
  EXPECT_NEAR(s.mean, 0.0209, 0.05 * 0.0209);
  EXPECT_NEAR(s.p99, 0.048, 0.05 * 0.048);
  EXPECT_LT(s.max, 0.060);
}

}  // namespace
}  // namespace velarium::shading
