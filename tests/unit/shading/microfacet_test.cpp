#include <gtest/gtest.h>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

// Integral of D cos over the hemisphere, with angles spaced as the lobe is: tan(theta) = alpha tan(x).
double integrate_distribution(float alpha, bool from_cosine) {
  constexpr int kSteps = 20000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = (i + 0.5) / kSteps * 0.5 * kPiExact;
    const double t = alpha * std::tan(x), c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
    const double d_theta = alpha / (std::cos(x) * std::cos(x)) / (1.0 + t * t) * 0.5 * kPiExact / kSteps;
    const double d =
        from_cosine ? d_ggx(static_cast<float>(c), alpha) : d_ggx_from_sin2(static_cast<float>(s * s), alpha);
    sum += d * c * 2.0 * kPiExact * s * d_theta;
  }
  return sum;
}

TEST(Microfacet, DistributionIsNormalised) {
  for (const float alpha : {0.000729f, 0.002325f, 0.0754188f, 0.3f, 1.0f}) {
    EXPECT_NEAR(integrate_distribution(alpha, false), 1.0, 1e-4) << alpha;
  }
  for (const float alpha : {0.0754188f, 0.3f, 1.0f})
    EXPECT_NEAR(integrate_distribution(alpha, true), 1.0, 1e-4) << alpha;
}

TEST(Microfacet, NarrowestLobeIsExactInSinglePrecision) {
  const double a2 = std::pow(0.000729, 2);
  for (const double theta : {0.0, 1e-4, 5e-4, 1e-3, 1e-2}) {
    const double s2 = std::sin(theta) * std::sin(theta), t = s2 + a2 * (1.0 - s2);
    const double exact = a2 / (kPiExact * t * t);
    EXPECT_NEAR(d_ggx_from_sin2(static_cast<float>(s2), 0.000729f) / exact, 1.0, 1e-5) << theta;
  }
}

TEST(Microfacet, RyseMaskingConstants) {
  EXPECT_NEAR(ryse_k(0.0f), 0.32000, 1e-5);
  EXPECT_NEAR(ryse_k(0.0754188f), 0.35087, 1e-5);
  EXPECT_NEAR(ryse_k(0.3f), 0.45125, 1e-5);
  EXPECT_NEAR(ryse_k(1.0f), 0.84500, 1e-5);
}

TEST(Microfacet, RyseAgainstSmith) {
  const auto ratio = [](float alpha, float cosine) {
    return visibility(kModelRyse, cosine, cosine, alpha) / visibility(kModelGltf, cosine, cosine, alpha);
  };
  EXPECT_NEAR(ratio(1e-6f, 1.0f), 1.000, 1e-3);
  EXPECT_NEAR(ratio(1e-6f, 0.5f), 0.574, 1e-3);
  EXPECT_NEAR(ratio(1e-6f, 0.1f), 0.066, 1e-3);
  EXPECT_NEAR(ratio(1.0f, 0.5f), 0.587, 1e-3);
  EXPECT_NEAR(ratio(1.0f, 0.1f), 0.135, 1e-3);
}

TEST(Microfacet, FresnelLimits) {
  const vec3 gold{1.0f, 0.766f, 0.336f};
  EXPECT_EQ(fresnel_schlick(gold, 1.0f, 1.0f), gold);
  EXPECT_EQ(fresnel_schlick(gold, 1.0f, 0.0f), vec3(1.0f));
  EXPECT_NEAR(fresnel_schlick(vec3(0.04f), 1.0f, 0.5f).x, 0.04 + 0.96 / 32.0, 1e-6);
}

TEST(Microfacet, ReflectanceBelowTwoPercentIsOcclusion) {
  EXPECT_EQ(f90_from_f0(vec3(0.0f)), 0.0f);
  EXPECT_NEAR(f90_from_f0(vec3(0.01f, 0.0f, 0.0f)), 0.5f, 1e-6);
  EXPECT_EQ(f90_from_f0(vec3(0.02f)), 1.0f);
  EXPECT_EQ(f90_from_f0(vec3(0.0f, 0.0f, 0.9f)), 1.0f);
}

}  // namespace
}  // namespace velarium::shading
