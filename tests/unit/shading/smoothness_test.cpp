#include <gtest/gtest.h>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

struct RemapRow {
  float smoothness, alpha;
  double blinn_phong_power, half_max_degrees;  // half_max 0: the lobe has none
};

// GGX lobe of each smoothness: alpha, the Blinn-Phong power of equal peak, the angle at which D halves.
constexpr RemapRow kRemap[] = {
    {0.0f, 1.000000f, 0, 0},           {0.1f, 0.646990f, 2.8, 33.10},     {0.2f, 0.404567f, 10.2, 16.54},
    {0.3f, 0.243087f, 31.8, 9.28},     {0.4f, 0.139314f, 101, 5.19},      {0.5f, 0.075419f, 350, 2.79},
    {0.6f, 0.038069f, 1378, 1.41},     {0.7f, 0.017596f, 6457, 0.649},    {0.8f, 0.007256f, 37982, 0.268},
    {0.9f, 0.002566f, 303813, 0.0946}, {1.0f, 0.000729f, 3.76e6, 0.0269},
};

TEST(Smoothness, GivesTheTabledAlphas) {
  for (const RemapRow& row : kRemap) {
    const double alpha = alpha_from_smoothness(row.smoothness);
    EXPECT_NEAR(alpha, row.alpha, 1e-6) << row.smoothness;
    const double power = 2.0 / (alpha * alpha) - 2.0;
    EXPECT_NEAR(power, row.blinn_phong_power, 0.002 * row.blinn_phong_power + 0.06) << row.smoothness;
  }
}

TEST(Smoothness, LobeHalvesAtTheTabledAngles) {
  for (const RemapRow& row : kRemap) {
    if (row.half_max_degrees == 0) continue;
    const double s = std::sin(radians(row.half_max_degrees));
    const float alpha = alpha_from_smoothness(row.smoothness);
    const double ratio = d_ggx_from_sin2(static_cast<float>(s * s), alpha) / d_ggx_from_sin2(0.0f, alpha);
    EXPECT_NEAR(ratio, 0.5, 0.003) << row.smoothness;
  }
}

TEST(Smoothness, RoundTrips) {
  for (int i = 0; i <= 1000; ++i) {
    const float s = static_cast<float>(i) / 1000.0f;
    EXPECT_NEAR(smoothness_from_alpha(alpha_from_smoothness(s)), s, 1e-6);
  }
}

TEST(Smoothness, HoldsPerceptualRoughness) {
  EXPECT_NEAR(smoothness_from_alpha(alpha_from_perceptual_roughness(0.09f)), 0.788f, 5e-4);
  EXPECT_EQ(smoothness_from_alpha(alpha_from_perceptual_roughness(1.0f)), 0.0f);
  EXPECT_EQ(smoothness_from_alpha(alpha_from_perceptual_roughness(0.02f)), 1.0f);
  EXPECT_EQ(smoothness_from_alpha(0.0f), 1.0f);
  EXPECT_NEAR(kMinAlpha, alpha_from_smoothness(1.0f), 1e-9);
}

TEST(Smoothness, PunctualHighlightFitsHalfFloats) {
  EXPECT_LT(d_ggx_from_sin2(0.0f, kMinAlphaPunctual), 65504.0f);
  EXPECT_NEAR(kMinAlphaPunctual, 0.5f * 0.00465f, 1e-7);
}

}  // namespace
}  // namespace velarium::shading
