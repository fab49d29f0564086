#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

constexpr float kTiny = 1e-6f;

// Moments of a filter that a share of blockers at one depth fills, the rest at another.
vec2 mixed(float share, float blocker, float rest) {
  return share * depth_moments(blocker) + (1.0f - share) * depth_moments(rest);
}

// Of a plane before the receiver's own, the bound is the share that is not hidden.
TEST(ChebyshevBound, IsExactForAPlaneBeforeAPlane) {
  for (const float share : {0.1f, 0.5f, 0.9f})
    EXPECT_NEAR(chebyshev_bound(mixed(share, 5.0f, 10.0f), 10.0f, kTiny), 1.0f - share, 1e-5f) << share;
}

// Nothing arrives behind two planes of which each fills half of the filter, one behind the other.
TEST(ChebyshevBound, LetsLightThroughBehindTwoBlockersUntilItIsCutOff) {
  const float bound = chebyshev_bound(mixed(0.5f, 5.0f, 10.0f), 14.0f, kTiny);
  EXPECT_NEAR(bound, 0.1289f, 5e-5f);
  EXPECT_EQ(without_bleeding(bound, 0.2f), 0.0f);
}

TEST(ChebyshevBound, LightsWhatIsBeforeTheMean) {
  EXPECT_EQ(chebyshev_bound(mixed(0.5f, 5.0f, 10.0f), 7.5f, kTiny), 1.0f);
  EXPECT_EQ(chebyshev_bound(depth_moments(3.0f), 2.0f, kTiny), 1.0f);
}

// A receiver that rounding puts behind itself is lit: at one least deviation half of the light is left.
TEST(ChebyshevBound, TakesTheLeastVarianceForOneSurface) {
  const float deviation = 0.25f;
  EXPECT_NEAR(chebyshev_bound(depth_moments(0.0f), deviation, deviation * deviation), 0.5f, 1e-6f);
  EXPECT_GT(chebyshev_bound(depth_moments(0.0f), 0.1f * deviation, deviation * deviation), 0.99f);
  EXPECT_LT(chebyshev_bound(depth_moments(0.0f), 10.0f * deviation, deviation * deviation), 0.01f);
}

TEST(WithoutBleeding, KeepsTheEndsAndRisesBetween) {
  EXPECT_EQ(without_bleeding(0.0f, 0.2f), 0.0f);
  EXPECT_EQ(without_bleeding(0.2f, 0.2f), 0.0f);
  EXPECT_NEAR(without_bleeding(0.6f, 0.2f), 0.5f, 1e-6f);
  EXPECT_EQ(without_bleeding(1.0f, 0.2f), 1.0f);
  EXPECT_EQ(without_bleeding(0.6f, 0.0f), 0.6f);
}

TEST(MomentDepth, GrowsAwayFromTheLightAboutTheMiddle) {
  EXPECT_EQ(moment_depth(1.0f), -0.5f);
  EXPECT_EQ(moment_depth(0.5f), 0.0f);
  EXPECT_EQ(moment_depth(0.0f), 0.5f);
}

// A blurred tilted plane has at each texel the mean that is its own depth there, and a variance of its own: it cannot
// hide itself, however steep it is.
TEST(Moments, OfATiltedPlaneDoNotHideIt) {
  for (const float slope : {0.001f, 0.02f, 0.1f}) {
    vec2 moments(0.0f);
    float weights = 0.0f;
    for (int i = -4; i <= 4; ++i) {
      const float weight = blur_weight(static_cast<float>(i), 1.5f);
      moments += weight * depth_moments(0.1f + slope * static_cast<float>(i));
      weights += weight;
    }
    EXPECT_GT(chebyshev_bound(moments / weights, 0.1f, 1e-8f), 0.9999f) << slope;
  }
}

// exp(-x^2 / 2): a deviation away.
TEST(BlurWeight, IsABellCurve) {
  EXPECT_EQ(blur_weight(0.0f, 2.0f), 1.0f);
  EXPECT_NEAR(blur_weight(2.0f, 2.0f), 0.60653066f, 1e-6f);
  EXPECT_NEAR(blur_weight(-4.0f, 2.0f), 0.13533528f, 1e-6f);
}

}  // namespace
}  // namespace velarium::shading
