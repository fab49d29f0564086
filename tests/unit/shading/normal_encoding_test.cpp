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

// Unit vectors as they are, on the same integers.
vec3 plain_codes(const vec3& n) {
  return unorm8((127.0f * n + vec3(128.0f)) / 255.0f);
}

glm::ivec3 codes_of(const vec3& stored) {
  return {code8(stored.x), code8(stored.y), code8(stored.z)};
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

// The figures are those of a search written apart from this code, in double.
TEST(BestFitNormals, ErrorsAreThoseOfTheSearch) {
  const Statistics fit = error_statistics(100000, [](const vec3& n) { return through_codes(n, best_fit_length(n)); });
  EXPECT_NEAR(fit.mean, 0.0304, 0.01 * 0.0304);
  EXPECT_NEAR(fit.rms, 0.0383, 0.01 * 0.0383);
  EXPECT_NEAR(fit.p99, 0.131, 0.02 * 0.131);
  EXPECT_LT(fit.max, kWorstNormalError);
  const Statistics plain = error_statistics(100000, [](const vec3& n) { return bfn_decode(plain_codes(n)); });
  EXPECT_NEAR(plain.mean, 0.171, 0.01 * 0.171);
  EXPECT_NEAR(plain.p99, 0.319, 0.01 * 0.319);
}

TEST(BestFitNormals, KnownDirections) {
  const vec3 exact = normalize(vec3(1.0f, 2.0f, 3.0f));
  ASSERT_EQ(best_fit_length(exact), 126);
  EXPECT_EQ(codes_of(bfn_encode(exact, 126.0f / 255.0f)), glm::ivec3(128 + 42, 128 + 84, 128 + 126));
  EXPECT_LT(angle_degrees(exact, through_codes(exact, 126)), 1e-5);
  const vec3 n = normalize(vec3(-83.0f, 131.0f, 51.0f));
  ASSERT_EQ(best_fit_length(n), 90);
  EXPECT_EQ(codes_of(bfn_encode(n, 90.0f / 255.0f)), glm::ivec3(128 - 57, 128 + 90, 128 + 35));
  EXPECT_NEAR(angle_degrees(n, through_codes(n, 90)), 0.0193, 1e-4);
}

// 0 is one of the integers. The table has 127 for axes, whose root and reciprocal fp32 gets right; of any other length
// they keep the direction.
TEST(BestFitNormals, AxesAreExact) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      vec3 n{0.0f};
      n[axis] = sign;
      glm::ivec3 codes{128};
      codes[axis] = sign > 0.0f ? 255 : 1;
      EXPECT_EQ(best_fit_length(n), 127);
      EXPECT_EQ(codes_of(unorm8(bfn_encode(n, 127.0f / 255.0f))), codes);
      EXPECT_EQ(through_codes(n, 127), n);
      for (int k = 1; k < 127; ++k) EXPECT_EQ(angle_degrees(n, through_codes(n, k)), 0.0) << k;
    }
  }
}

// Devices may leave a few units in the last place beside c / 255; what is decoded does not show it.
TEST(BestFitNormals, CodesDecodeToIntegers) {
  for (int k = -127; k <= 127; ++k) {
    for (const float off : {-1e-6f, 0.0f, 1e-6f}) {
      const float stored = static_cast<float>(k + 128) / 255.0f + off, one = 129.0f / 255.0f + off;
      const vec3 n = bfn_decode(vec3(stored, one, 128.0f / 255.0f + off));
      EXPECT_EQ(n, normalize(vec3(static_cast<float>(k), 1.0f, 0.0f))) << k;
    }
  }
}

constexpr float kTableSize = 512.0f;

TEST(BestFitNormals, TableIsReadBySortedComponents) {
  // Sorted, to a largest of 1: (1, 1/2, 1/4), whose sum is 3/4 and whose difference is 1/4.
  for (const vec3 n : {vec3(0.2f, 0.4f, 0.8f), vec3(-0.8f, 0.2f, -0.4f), vec3(0.4f, -0.8f, 0.2f)})
    EXPECT_LT(length(bfn_table_texel(n, kTableSize) - vec2(0.75f * 511.0f + 1.0f, 0.25f * 511.0f)), 1e-3f);
  // (1, 3/4, 1/2) lies beyond a sum of 1: 5/4 and 1/4.
  for (const vec3 n : {vec3(0.4f, 0.6f, 0.8f), vec3(-0.6f, -0.8f, 0.4f)})
    EXPECT_LT(length(bfn_table_texel(n, kTableSize) - vec2(0.25f * 511.0f, 0.75f * 511.0f + 1.0f)), 1e-3f);
  EXPECT_EQ(bfn_table_texel(vec3(0, 1, 0), kTableSize), vec2(1.0f, 0.0f));
  EXPECT_EQ(bfn_table_texel(vec3(-1, 1, 1), kTableSize), vec2(0.0f, 1.0f));
  EXPECT_EQ(bfn_table_texel(vec3(-1, 0, 1), kTableSize), vec2(511.0f, 511.0f));
}

// A texel's direction is read from that texel; on the diagonal the last alone is read.
TEST(BestFitNormals, TexelsKnowTheirDirections) {
  for (const int count : {2, 7, 64, 512}) {
    const float size = static_cast<float>(count);
    for (int i = 0; i < count * count; ++i) {
      const vec2 texel = vec2(i % count, i / count) + vec2(0.5f);
      const vec3 n = bfn_table_direction(texel, size);
      ASSERT_EQ(n.x, 1.0f);
      ASSERT_TRUE(n.y <= 1.0f && n.z >= 0.0f && n.z <= n.y) << count << ": " << texel.x << ' ' << texel.y;
      if (texel.x == texel.y) continue;
      ASSERT_EQ(glm::floor(bfn_table_texel(n, size)), glm::floor(texel)) << count << ": " << texel.x << ' ' << texel.y;
    }
    EXPECT_EQ(bfn_table_direction(vec2(size - 0.5f), size), vec3(1.0f, 1.0f, 0.0f));
  }
}

TEST(BestFitNormals, DirectionsLieWithinTheirTexels) {
  Random random(5);
  for (int i = 0; i < 100000; ++i) {
    const vec3 n = random.direction(), m = glm::abs(n) / max_component(glm::abs(n));
    const vec2 texel = glm::floor(bfn_table_texel(n, kTableSize));
    ASSERT_TRUE(texel.x >= 0.0f && texel.x < kTableSize && texel.y >= 0.0f && texel.y < kTableSize);
    ASSERT_NE(texel.x, texel.y);
    const vec3 center = bfn_table_direction(texel + vec2(0.5f), kTableSize);
    // Half a texel of sum and difference is as much of either component, at the most.
    ASSERT_NEAR(center.z, min_component(m), 0.501f / 511.0f);
    ASSERT_NEAR(center.y, m.x + m.y + m.z - 1.0f - min_component(m), 0.501f / 511.0f);
  }
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
  EXPECT_NEAR(static_cast<double>(distinct_codes(plain_codes)), 222282, 444);
  const auto fit = [](const vec3& n) { return unorm8(bfn_encode(n, static_cast<float>(best_fit_length(n)) / 255.0f)); };
  EXPECT_NEAR(static_cast<double>(distinct_codes(fit)), 387098, 774);  // [Kaplanyan 2010]: 387107
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
