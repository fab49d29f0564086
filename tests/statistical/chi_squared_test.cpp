// The tester is tested: it knows the distribution, lets good samplers pass and catches bad ones.

#include "statistical/chi_squared.hpp"

namespace velarium::statistical {
namespace {

// Upper 5 % and 0.1 % points of the distribution [Abramowitz & Stegun 1964, table 26.8].
TEST(ChiSquared, KnowsTheTabledDistribution) {
  EXPECT_NEAR(chi_squared_p_value(3.84146, 1), 0.05, 1e-6);
  EXPECT_NEAR(chi_squared_p_value(5.99147, 2), 0.05, 1e-6);
  EXPECT_NEAR(chi_squared_p_value(18.3070, 10), 0.05, 1e-6);
  EXPECT_NEAR(chi_squared_p_value(29.588, 10), 0.001, 1e-6);
  EXPECT_NEAR(chi_squared_p_value(124.342, 100), 0.05, 1e-5);
  EXPECT_NEAR(chi_squared_p_value(149.449, 100), 0.001, 1e-6);
  EXPECT_EQ(chi_squared_p_value(0.0, 7), 1.0);
}

// With two degrees of freedom the distribution is exponential.
TEST(ChiSquared, TwoDegreesOfFreedomHaveAClosedForm) {
  for (const double x : {0.1, 1.0, 2.9, 3.1, 10.0, 100.0})
    EXPECT_NEAR(chi_squared_p_value(x, 2) / std::exp(-0.5 * x), 1.0, 1e-12) << x;
}

TEST(ChiSquared, PoolsSmallBins) {
  const std::vector<double> observed{30, 1, 3, 2, 64}, expected{28, 2, 2, 2, 66};
  const Verdict verdict = compare_counts(observed, expected);
  EXPECT_EQ(verdict.degrees_of_freedom, 2);
  EXPECT_NEAR(verdict.statistic, 4.0 / 28.0 + 0.0 / 6.0 + 4.0 / 66.0, 1e-12);
}

TEST(ChiSquared, CountsWhatFellWhereNothingMay) {
  const std::vector<double> observed{50, 49, 1}, expected{50, 50, 0};
  EXPECT_LT(compare_counts(observed, expected).p_value, 1e-6);
}

TEST(ChiSquared, SidakSharesTheSignificance) {
  Verdict verdict;
  verdict.p_value = 0.0102;
  EXPECT_TRUE(agrees(verdict, 1));
  verdict.p_value = 0.0098;
  EXPECT_FALSE(agrees(verdict, 1));
  EXPECT_TRUE(agrees(verdict, 10));  // 1 - 0.99^(1/10) = 0.0010045
  verdict.p_value = 0.0010;
  EXPECT_FALSE(agrees(verdict, 10));
}

// A lobe about +z with density (exponent / 2 pi) cos^(exponent - 1): 2 is the cosine lobe.
vec3 sample_power_lobe(Random& random, double exponent) {
  const double z = std::pow(static_cast<double>(random.uniform()), 1.0 / exponent);
  const double r = std::sqrt(1.0 - z * z), phi = 2.0 * shading::kPiExact * random.uniform();
  return {r * std::cos(phi), r * std::sin(phi), z};
}

double cosine_density(const vec3& d) {
  return std::max(d.z, 0.0f) / shading::kPiExact;
}

constexpr Experiment kEightHundred{.samples = 400000, .seed = 1, .columns = 20, .rows = 80};  // bins above the surface

TEST(ChiSquared, PassesACosineLobe) {
  const auto sampler = [](Random& random) { return sample_power_lobe(random, 2.0); };
  EXPECT_TRUE(agrees(test_on_sphere(sampler, cosine_density, {}, kEightHundred), 1));
}

TEST(ChiSquared, CatchesAWrongExponent) {
  const auto sampler = [](Random& random) { return sample_power_lobe(random, 2.05); };
  EXPECT_FALSE(agrees(test_on_sphere(sampler, cosine_density, {}, kEightHundred), 1));
}

// A density over the polar angle and azimuth, given out as one over solid angle: sin(theta) is missing.
TEST(ChiSquared, CatchesAMissingJacobian) {
  const auto sampler = [](Random& random) { return sample_power_lobe(random, 2.0); };
  const auto density = [](const vec3& d) { return cosine_density(d) * std::sqrt(std::max(1.0f - d.z * d.z, 0.0f)); };
  EXPECT_FALSE(agrees(test_on_sphere(sampler, density, {}, kEightHundred), 1));
}

// The shape alone is right; the total gives it away.
TEST(ChiSquared, CatchesAWrongNormalisation) {
  const auto sampler = [](Random& random) { return sample_power_lobe(random, 2.0); };
  for (const double factor : {0.98, 1.02}) {
    const auto density = [&](const vec3& d) { return factor * cosine_density(d); };
    EXPECT_FALSE(agrees(test_on_sphere(sampler, density, {}, kEightHundred), 1)) << factor;
  }
}

TEST(ChiSquared, IsNotMovedByItsBins) {
  const auto sampler = [](Random& random) { return sample_power_lobe(random, 2.0); };
  const vec3 aside = glm::normalize(vec3(0.6f, -0.3f, 0.7f));
  for (const SphereBins& bins : {SphereBins{aside, 1}, SphereBins{aside, 4}, SphereBins{vec3(0.0f, 0.0f, 1.0f), 3}})
    EXPECT_TRUE(agrees(test_on_sphere(sampler, cosine_density, bins, {}), 3));
}

TEST(ChiSquared, SeesDependence) {
  Random random(1);
  std::vector<double> apart(64), tied(64);
  for (int i = 0; i < 20000; ++i) {
    const float x = random.uniform(), y = random.uniform();
    ++apart[static_cast<std::size_t>(y * 8.0f) * 8 + static_cast<std::size_t>(x * 8.0f)];
    ++tied[static_cast<std::size_t>((0.9f * y + 0.1f * x) * 8.0f) * 8 + static_cast<std::size_t>(x * 8.0f)];
  }
  EXPECT_TRUE(agrees(test_independence(apart, 8), 1));
  EXPECT_FALSE(agrees(test_independence(tied, 8), 1));
}

}  // namespace
}  // namespace velarium::statistical
