// The legacy model: a lobe of unit energy that peaks where GGX does.

#include <gtest/gtest.h>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

constexpr float kAlphas[] = {0.000729f, 0.002325f, 0.017596f, 0.0754188f, 0.3f, 0.6f, 1.0f};

// (n + 2) / (2 pi) cos^n integrates to 1 with the cosine, whatever the exponent. Angles are spaced as GGX's lobe of
// this width is: tan(theta) = alpha tan(x).
TEST(BlinnPhong, DistributionIsNormalised) {
  constexpr int kSteps = 20000;
  for (const float alpha : kAlphas) {
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = (i + 0.5) / kSteps * 0.5 * kPiExact;
      const double t = alpha * std::tan(x), c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
      const double d_theta = alpha / (std::cos(x) * std::cos(x)) / (1.0 + t * t) * 0.5 * kPiExact / kSteps;
      sum += d_blinn_phong_from_sin2(static_cast<float>(s * s), alpha) * c * 2.0 * kPiExact * s * d_theta;
    }
    EXPECT_NEAR(sum, 1.0, 1e-4) << alpha;
  }
}

// Exponents of equal peak, to the digits that they are tabled with.
TEST(BlinnPhong, ExponentsAreTheTabledOnes) {
  EXPECT_EQ(blinn_phong_exponent(1.0f), 0.0f);
  EXPECT_NEAR(blinn_phong_exponent(alpha_from_smoothness(0.1f)), 2.8, 0.05);
  EXPECT_NEAR(blinn_phong_exponent(alpha_from_smoothness(0.3f)), 31.8, 0.05);
  EXPECT_NEAR(blinn_phong_exponent(alpha_from_smoothness(0.5f)), 350.0, 0.5);
  EXPECT_NEAR(blinn_phong_exponent(alpha_from_smoothness(0.7f)), 6457.0, 1.0);
  EXPECT_NEAR(blinn_phong_exponent(alpha_from_smoothness(1.0f)), 3.76e6, 0.01e6);
}

TEST(BlinnPhong, PeaksWhereGgxDoes) {
  for (const float alpha : kAlphas)
    EXPECT_NEAR(d_blinn_phong_from_sin2(0.0f, alpha) / d_ggx_from_sin2(0.0f, alpha), 1.0f, 1e-6f) << alpha;
}

// Hoffman's (n + 2) / (8 pi) (n.h)^n f0 n.l, in double.
TEST(BlinnPhong, IsTheNormalisedForm) {
  const Surface metal{vec3(0.0f, 0.0f, 1.0f), vec3(0.0f), vec3(1.0f), 0.5f, 1.0f, 0.0f, vec2(0.0f), kClassStandard};
  for (const double n : {0.0, 2.8, 31.8, 350.0, 6457.0}) {
    const auto alpha = static_cast<float>(std::sqrt(2.0 / (n + 2.0)));
    for (const double tilt : {0.0, 0.01, 0.05, 0.2, 0.6}) {
      const glm::dvec3 wo(std::sin(0.5), 0.0, std::cos(0.5)), wi(std::sin(tilt - 0.5), 0.0, std::cos(tilt - 0.5));
      const double n_dot_h = glm::normalize(wo + wi).z;
      const double expected = (n + 2.0) / (8.0 * kPiExact) * std::pow(n_dot_h, n) * wi.z;
      const float actual = evaluate_brdf(metal, alpha, vec3(wo), vec3(wi), vec3(1.0f), kModelBlinnPhong).x;
      EXPECT_NEAR(actual, expected, 1e-4 * expected + 1e-30) << n << ' ' << tilt;
    }
  }
}

// Without its series the logarithm keeps no digit of the narrowest lobe.
TEST(BlinnPhong, NarrowestLobeIsExactInSinglePrecision) {
  for (const float alpha : {0.000729f, 0.002325f, 0.0754188f}) {
    const double m = 1.0 / (double{alpha} * alpha) - 1.0;
    for (const double width : {0.0, 0.3, 1.0, 2.0, 3.0}) {
      const auto sin2 = static_cast<float>(width * width * alpha * alpha);
      const double exact = std::exp(m * std::log1p(-double{sin2})) / (kPiExact * alpha * alpha);
      EXPECT_NEAR(d_blinn_phong_from_sin2(sin2, alpha) / exact, 1.0, 1e-5) << alpha << ' ' << width;
    }
  }
}

TEST(BlinnPhong, LogarithmIsExactOnBothSidesOfItsSeam) {
  for (const float x : {0.0f, 1e-12f, 1e-6f, 0.01f, 0.0624f, 0.0626f, 0.5f, 0.999f})
    EXPECT_NEAR(log2_one_minus(x), std::log1p(-double{x}) / std::log(2.0), 4e-7 * -std::log1p(-double{x})) << x;
  EXPECT_TRUE(std::isfinite(log2_one_minus(1.0f)));
}

// D / 4 n.l of exponent 0 is n.l / (4 pi), so that a white metal reflects a quarter, from wherever it is seen.
TEST(BlinnPhong, RoughestMetalReflectsAQuarter) {
  const Surface metal{vec3(0.0f, 0.0f, 1.0f), vec3(0.0f), vec3(1.0f), 0.0f, 1.0f, 0.0f, vec2(0.0f), kClassStandard};
  for (const float n_dot_v : {0.05f, 0.5f, 1.0f}) {
    const vec3 wo(std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v);
    constexpr int kRings = 200;
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i)
      for (int j = 0; j < kRings; ++j) {
        const double c = (i + 0.5) / kRings, s = std::sqrt(1.0 - c * c), phi = 2.0 * kPiExact * (j + 0.5) / kRings;
        const vec3 wi(glm::dvec3(s * std::cos(phi), s * std::sin(phi), c));
        sum += evaluate_brdf(metal, 1.0f, wo, wi, vec3(1.0f), kModelBlinnPhong).x;
      }
    EXPECT_NEAR(sum * 2.0 * kPiExact / (kRings * kRings), 0.25, 1e-4) << n_dot_v;
  }
}

}  // namespace
}  // namespace velarium::shading
