#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

TEST(Sampling, RadicalInverseMirrorsBits) {
  EXPECT_EQ(radical_inverse(0u), 0.0f);
  EXPECT_EQ(radical_inverse(1u), 0.5f);
  EXPECT_EQ(radical_inverse(2u), 0.25f);
  EXPECT_EQ(radical_inverse(3u), 0.75f);
  EXPECT_EQ(radical_inverse(6u), 0.375f);
  EXPECT_LT(radical_inverse(0xffffffffu), 1.0f);
}

TEST(Sampling, HammersleyFillsEachCellOnce) {
  std::vector<int> cells(64, 0);
  for (uint i = 0; i < 64; ++i) {
    const vec2 p = hammersley(i, 64u);
    ++cells[static_cast<std::size_t>(p.y * 8.0f) * 8 + static_cast<std::size_t>(p.x * 8.0f)];
  }
  EXPECT_TRUE(std::all_of(cells.begin(), cells.end(), [](int n) { return n == 1; }));
}

TEST(Sampling, HashIsABijectionThatLooksUniform) {
  std::vector<uint> hashes;
  double mean = 0.0;
  constexpr uint kCount = 1u << 17;
  for (uint i = 0; i < kCount; ++i) {
    hashes.push_back(hash_u32(i));
    mean += hash_to_float(i) / kCount;
    ASSERT_LT(hash_to_float(i), 1.0f);
  }
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end());
  EXPECT_NEAR(mean, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / kCount));
}

TEST(Sampling, JitterIsCentredForEveryCount) {
  EXPECT_EQ(pixel_jitter(7u, 1u), vec2(0.0f));
  for (const uint count : {2u, 3u, 8u, 16u, 61u, 256u}) {
    vec2 sum{0.0f};
    for (uint i = 0; i < count; ++i) {
      const vec2 j = pixel_jitter(i + 3u * count, count);
      ASSERT_LE(std::max(std::abs(j.x), std::abs(j.y)), 0.5f);
      sum += j;
    }
    EXPECT_LT(length(sum) / static_cast<float>(count), 1e-5f) << count;
  }
}

// Offsets spread over the pixel: each cell of a 4 x 4 grid gets its share of 64, 4, give or take 2.
TEST(Sampling, JitterCoversThePixel) {
  std::vector<int> cells(16, 0);
  for (uint i = 0; i < 64; ++i) {
    const vec2 p = pixel_jitter(i, 64u) + vec2(0.5f);
    ++cells[static_cast<std::size_t>(p.y * 4.0f) * 4 + static_cast<std::size_t>(p.x * 4.0f)];
  }
  for (const int n : cells) EXPECT_NEAR(n, 4, 2);
}

TEST(Sampling, RoundingIsCentredForEveryCount) {
  EXPECT_EQ(rounding_shift(7u, 1u), 0.0f);
  for (const uint count : {2u, 3u, 8u, 16u, 61u, 256u}) {
    float sum = 0.0f;
    for (uint i = 0; i < count; ++i) {
      const float shift = rounding_shift(i + 3u * count, count);
      ASSERT_LE(std::abs(shift), 0.5f);
      sum += shift;
    }
    EXPECT_LT(std::abs(sum) / static_cast<float>(count), 1e-5f) << count;
  }
}

// Whatever a pixel starts with, 16 frames have two numbers in each eighth, give or take one.
TEST(Sampling, NoiseOfFramesFillsTheUnitInterval) {
  for (uint x = 0; x < 50; ++x) {
    std::vector<int> cells(8, 0);
    for (uint frame = 0; frame < 16; ++frame)
      ++cells[static_cast<std::size_t>(8.0f * screen_noise({x, 7u}, frame, 5u))];
    for (const int n : cells) EXPECT_NEAR(n, 2, 1) << x;
  }
}

TEST(Sampling, NoiseDependsOnFrameAndSeed) {
  const uvec2 pixel{100, 200};
  EXPECT_NE(screen_noise(pixel, 0u, 0u), screen_noise(pixel, 1u, 0u));
  EXPECT_NE(screen_noise(pixel, 0u, 0u), screen_noise(pixel, 0u, 1u));
  EXPECT_EQ(screen_noise(pixel, 3u, 4u), screen_noise(pixel, 3u, 4u));
}

TEST(Sampling, TangentSpaceIsARotation) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const vec3 n = i == 0 ? vec3(0, 0, -1) : random.direction();
    const vec3 x = from_tangent_space(vec3(1, 0, 0), n), y = from_tangent_space(vec3(0, 1, 0), n);
    ASSERT_LT(length(from_tangent_space(vec3(0, 0, 1), n) - n), 1e-6f);
    ASSERT_NEAR(length(x), 1.0f, 1e-5);
    ASSERT_LT(length(cross(x, y) - n), 1e-5f);
  }
}

TEST(Sampling, HalfVectorsFollowTheDistribution) {
  for (const float alpha : {0.0754188f, 0.3f, 1.0f}) {
    for (const float u : {0.01f, 0.25f, 0.5f, 0.9f}) {
      const vec3 h = sample_ggx_half_vector(vec2(u, 0.37f), alpha);
      EXPECT_NEAR(length(h), 1.0f, 1e-6);
      // Share of D cos(theta) up to this angle.
      constexpr int kSteps = 20000;
      double share = 0.0;
      for (int i = 0; i < kSteps; ++i) {
        const double s2 = (i + 0.5) / kSteps * (1.0 - h.z * h.z);
        share += d_ggx_from_sin2(static_cast<float>(s2), alpha) * kPiExact * (1.0 - h.z * h.z) / kSteps;
      }
      EXPECT_NEAR(share, u, 1e-3) << alpha;
    }
  }
}

// Mean of a test function over samples against its integral with the density, on the sphere of mirrored directions.
TEST(Sampling, VisibleHalfVectorsMeetTheirDensity) {
  for (const float alpha : {0.2f, 0.5f, 1.0f}) {
    for (const float n_dot_v : {0.1f, 0.6f, 1.0f}) {
      const vec3 wo{std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v};
      const auto probe = [&](const vec3& wi) { return 1.0 + 0.5 * wi.x + wi.z * wi.z + 0.3 * wi.y * wi.y; };
      constexpr uint kSamples = 1u << 15;
      double sampled = 0.0;
      for (uint i = 0; i < kSamples; ++i) {
        const vec3 h = sample_ggx_visible_half_vector(wo, hammersley(i, kSamples), alpha);
        sampled += probe(2.0f * dot(wo, h) * h - wo) / kSamples;
      }
      constexpr int kSteps = 1000;
      double total = 0.0, expected = 0.0;
      for (int i = 0; i < kSteps; ++i) {
        const float z = -1.0f + 2.0f * (static_cast<float>(i) + 0.5f) / kSteps, r = std::sqrt(1.0f - z * z);
        for (int j = 0; j < kSteps; ++j) {
          const float phi = kTwoPi * (static_cast<float>(j) + 0.5f) / kSteps;
          const vec3 wi{r * std::cos(phi), r * std::sin(phi), z};
          const vec3 h = normalize(wo + wi);
          if (h.z <= 0.0f) continue;
          const double weight =
              pdf_sr_ggx_visible(h.x * h.x + h.y * h.y, n_dot_v, alpha) * 4.0 * kPiExact / (kSteps * kSteps);
          total += weight;
          expected += weight * probe(wi);
        }
      }
      EXPECT_NEAR(total, 1.0, 2e-3) << alpha << ' ' << n_dot_v;
      EXPECT_NEAR(sampled, expected, 4e-3) << alpha << ' ' << n_dot_v;
    }
  }
}

}  // namespace
}  // namespace velarium::shading
