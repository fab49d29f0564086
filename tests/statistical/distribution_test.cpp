#include "reference/distribution.hpp"
#include "statistical/chi_squared.hpp"

#include <array>
#include <limits>
#include <numeric>

namespace velarium::statistical {
namespace {

using reference::Distribution1d, reference::Distribution2d;

constexpr float kLargestBelowOne = 0x1.fffffep-1f;

TEST(Distribution, ChoosesByWeight) {
  const std::array<float, 5> weights{3.0f, 0.0f, 1.0f, 4.0f, 0.0f};
  const Distribution1d d(weights);
  EXPECT_FALSE(d.empty());
  EXPECT_EQ(d.total(), 8.0);
  EXPECT_EQ(d.probability(1), 0.0f);
  EXPECT_EQ(d.probability(3), 0.5f);
  struct Row {
    float u;
    std::uint32_t index;
    float probability, rest;
  };
  for (const Row& row : {Row{0.0f, 0, 0.375f, 0.0f}, Row{0.1875f, 0, 0.375f, 0.5f}, Row{0.375f, 2, 0.125f, 0.0f},
                         Row{0.5f, 3, 0.5f, 0.0f}, Row{0.75f, 3, 0.5f, 0.5f}}) {
    const auto sample = d.sample(row.u);
    EXPECT_EQ(sample.index, row.index) << row.u;
    EXPECT_EQ(sample.probability, row.probability) << row.u;
    EXPECT_EQ(sample.rest, row.rest) << row.u;
  }
  EXPECT_EQ(d.sample(kLargestBelowOne).index, 3u);  // not the last, which weighs nothing
}

TEST(Distribution, WithoutWeightIsEmpty) {
  EXPECT_TRUE(Distribution1d({}).empty());
  const std::array<float, 4> zeros{};
  EXPECT_TRUE(Distribution1d(zeros).empty());
  EXPECT_EQ(Distribution1d(zeros).probability(2), 0.0f);
  const Distribution2d grid(zeros, 2, 2);
  EXPECT_TRUE(grid.empty());
  EXPECT_EQ(grid.pdf({0.3f, 0.7f}), 0.0f);
}

TEST(Distribution, NeverChoosesWhatWeighsNothing) {
  Random random(2);
  std::vector<float> weights(1000);
  for (std::size_t i = 0; i < weights.size(); i += 3) weights[i] = random.uniform();
  const Distribution1d d(weights);
  for (int i = 0; i < 100000; ++i) {
    const auto sample = d.sample(random.uniform());
    ASSERT_GT(sample.probability, 0.0f);
    ASSERT_TRUE(sample.rest >= 0.0f && sample.rest < 1.0f);
  }
}

TEST(Distribution, MeetsItsProbabilities) {
  Random random(3);
  std::vector<float> weights;
  for (int i = 0; i < 300; ++i) weights.push_back(i % 7 == 0 ? 0.0f : std::pow(random.uniform(), 4.0f));
  const Distribution1d d(weights);
  constexpr int kSamples = 200000;
  std::vector<double> observed(weights.size()), expected;
  for (std::uint32_t i = 0; i < d.size(); ++i) expected.push_back(double{d.probability(i)} * kSamples);
  for (int i = 0; i < kSamples; ++i) ++observed[d.sample(random.uniform()).index];
  EXPECT_TRUE(agrees(compare_counts(observed, expected), 1));
  EXPECT_NEAR(std::accumulate(expected.begin(), expected.end(), 0.0), kSamples, 1e-6 * kSamples);
}

// What a choice leaves of u is as good as a fresh number.
TEST(Distribution, RestIsUniform) {
  const std::array<float, 3> weights{1.0f, 5.0f, 2.0f};
  const Distribution1d d(weights);
  const auto sampler = [&](Random& random) -> std::optional<vec2> {
    const auto sample = d.sample(random.uniform());
    return vec2(sample.rest, (static_cast<float>(sample.index) + 0.5f) / 3.0f);
  };
  const auto density = [&](const vec2& p) { return 3.0 * d.probability(static_cast<std::uint32_t>(p.y * 3.0f)); };
  EXPECT_TRUE(agrees(test_on_square(sampler, density, {.columns = 32, .rows = 3}), 1));
}

std::vector<float> rough_grid(std::uint32_t cells) {
  Random random(4);
  std::vector<float> weights;
  for (std::uint32_t i = 0; i < cells; ++i) weights.push_back(i % 5 == 0 ? 0.0f : random.uniform());
  weights[cells / 2] = 20.0f;
  return weights;
}

TEST(Distribution, GridMeetsItsDensity) {
  const Distribution2d grid(rough_grid(12 * 10), 12, 10);
  const auto sampler = [&](Random& random) -> std::optional<vec2> {
    const float x = random.uniform();
    return grid.sample({x, random.uniform()}).uv;
  };
  const auto pdf = [&](const vec2& p) { return grid.pdf(p); };
  EXPECT_TRUE(agrees(test_on_square(sampler, pdf, {.columns = 36, .rows = 20}), 1));
}

TEST(Distribution, GridSampleKnowsItsDensityAndCell) {
  const Distribution2d grid(rough_grid(7 * 11), 7, 11);
  Random random(5);
  for (int i = 0; i < 100000; ++i) {
    const float x = random.uniform();
    const auto sample = grid.sample({x, random.uniform()});
    ASSERT_GT(sample.pdf, 0.0f);
    ASSERT_TRUE(sample.uv.x < 1.0f && sample.uv.y < 1.0f);
    const vec2 middle = (vec2(sample.cell) + 0.5f) / vec2(7.0f, 11.0f);
    ASSERT_EQ(grid.pdf(middle), sample.pdf);
    ASSERT_LE(std::abs(sample.uv.x - middle.x), 0.5f / 7.0f + 1e-6f);
    ASSERT_LE(std::abs(sample.uv.y - middle.y), 0.5f / 11.0f + 1e-6f);
  }
}

// Sums that a float does not hold.
TEST(Distribution, HugeWeightsDoNotOverflow) {
  const std::vector<float> weights(16, 0.5f * std::numeric_limits<float>::max());
  const Distribution2d grid(weights, 4, 4);
  EXPECT_NEAR(grid.pdf({0.9f, 0.1f}), 1.0f, 1e-6);
  EXPECT_NEAR(grid.sample({0.9f, 0.1f}).pdf, 1.0f, 1e-6);
}

}  // namespace
}  // namespace velarium::statistical
