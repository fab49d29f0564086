#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

float square(float x) {
  return x * x;
}

struct MeanLengthRow {
  float smoothness, mean_length;
  double alpha;  // a'
};

// Toksvig's variance through the remap of smoothness: a'^2 = a^2 + 2 (1 - r) / r.
constexpr MeanLengthRow kMeanLengths[] = {
    {0.9f, 0.9999f, 0.01437}, {0.9f, 0.999f, 0.04482}, {0.9f, 0.99f, 0.14216}, {0.9f, 0.95f, 0.32445},
    {0.7f, 0.9999f, 0.02258}, {0.7f, 0.999f, 0.04808}, {0.7f, 0.99f, 0.14322}, {0.7f, 0.95f, 0.32492},
    {0.5f, 0.9999f, 0.07673}, {0.5f, 0.999f, 0.08769}, {0.5f, 0.99f, 0.16090}, {0.5f, 0.95f, 0.33309},
};

TEST(NormalVariance, SpreadIsToksvigs) {
  for (const MeanLengthRow& row : kMeanLengths) {
    const float alpha = alpha_from_smoothness(row.smoothness), spread = spread_from_mean_length(row.mean_length);
    // 1 - r of a 32-bit r is off by 6e-8.
    EXPECT_NEAR(std::hypot(alpha, spread), row.alpha, 2e-5) << row.mean_length;
  }
}

TEST(NormalVariance, UnitMeansChangeNothing) {
  EXPECT_EQ(spread_from_mean_length(1.0f), 0.0f);
  EXPECT_EQ(spread2_from_screen_mean(1.0f), 0.0f);
  EXPECT_EQ(interpolated_mean_length(1.0f), 1.0f);
  EXPECT_EQ(widened_alpha(0.0f, 0.0f), 0.0f);
  for (float s = 0.0f; s <= 1.0f; s += 0.125f) EXPECT_NEAR(widened_smoothness(s, 0.0f), s, 1e-6f);
}

TEST(NormalVariance, LengthsThatRoundingLeftOverOneAreOne) {
  EXPECT_EQ(spread_from_mean_length(1.0000002f), 0.0f);
  EXPECT_EQ(spread2_from_screen_mean(1.0000002f), 0.0f);
}

TEST(NormalVariance, NothingIsWiderThanAlphaOne) {
  EXPECT_EQ(spread_from_mean_length(0.0f), 1.0f);
  EXPECT_EQ(widened_alpha(0.5f, spread2_from_screen_mean(0.0f)), 1.0f);
  EXPECT_EQ(widened_alpha(0.7f, 1.0f), 1.0f);
  EXPECT_EQ(widened_smoothness(0.0f, 1.0f), 0.0f);
}

// The mean length of normals whose slopes are Gaussian with deviation `slope` along each axis.
double mean_length(double slope) {
  constexpr int kRings = 20000;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double r2 = -2.0 * slope * slope * std::log(1.0 - (i + 0.5) / kRings);
    sum += 1.0 / std::sqrt(1.0 + r2);
  }
  return sum / kRings;
}

// Both estimators give the variance of the slopes, and agree where it is small.
TEST(NormalVariance, IsThatOfGaussianSlopes) {
  for (const double slope : {0.05, 0.1}) {
    const auto r = static_cast<float>(mean_length(slope));
    const double v = slope * slope;
    EXPECT_NEAR(0.5f * square(spread_from_mean_length(r)), v, 0.03 * v);
    EXPECT_NEAR(0.5f * spread2_from_screen_mean(r), v, 0.04 * v);
  }
  // At a deviation of 0.4: (1 - r) / r = 0.1290 and 1 / kappa = 0.1098.
  const auto r = static_cast<float>(mean_length(0.4));
  EXPECT_NEAR(0.5f * square(spread_from_mean_length(r)), 0.1290, 5e-4);
  EXPECT_NEAR(0.5f * spread2_from_screen_mean(r), 0.1098, 5e-4);
}

// Three normals and two that are 20 degrees off: r = 0.985420, kappa = 69.0686.
TEST(NormalVariance, OfFiveTapsOnTheScreen) {
  const double turn = radians(20.0);
  const vec3 sum = 3.0f * vec3(0.0f, 0.0f, 1.0f) +
                   2.0f * vec3(static_cast<float>(std::sin(turn)), 0.0f, static_cast<float>(std::cos(turn)));
  const float r = length(sum) / 5.0f;
  EXPECT_NEAR(r, 0.985420f, 1e-6f);
  const float spread2 = spread2_from_screen_mean(r);
  EXPECT_NEAR(2.0f / spread2, 69.0686f, 0.01f);
}

// The length of the mean of all unit normals that a bilinear filter shows between four.
double shown_length(const std::array<vec3, 4>& corners) {
  constexpr int kSteps = 64;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const float x = (static_cast<float>(i % kSteps) + 0.5f) / kSteps,
                y = (static_cast<float>(i / kSteps) + 0.5f) / kSteps;
    sum += glm::dvec3(normalize(mix(mix(corners[0], corners[1], x), mix(corners[2], corners[3], x), y)));
  }
  return length(sum) / (kSteps * kSteps);
}

// Exactly, 2/3 of the variance of four texels is taken where they lean with their place, and 3/4 and more where
// neighbours lean apart.
TEST(NormalVariance, FiltersShowLessThanTheTexelsSpread) {
  const auto leaning = [](float x, float y) { return normalize(vec3(x, y, 1.0f)); };
  const std::array smooth{leaning(-0.1f, -0.05f), leaning(0.1f, -0.05f), leaning(-0.1f, 0.05f), leaning(0.1f, 0.05f)};
  const std::array apart{leaning(-0.1f, 0.0f), leaning(0.1f, 0.1f), leaning(0.1f, -0.1f), leaning(-0.1f, 0.0f)};
  for (const auto& corners : {smooth, apart}) {
    const float r = length(corners[0] + corners[1] + corners[2] + corners[3]) / 4.0f;
    EXPECT_NEAR(interpolated_mean_length(r), shown_length(corners), 0.15 * (1.0 - static_cast<double>(r)));
    EXPECT_GT(shown_length(corners), r + 0.5 * (1.0 - static_cast<double>(r)));
  }
}

TEST(NormalVariance, NeighboursCountLessTheFartherTheyAreFromTheSurface) {
  EXPECT_EQ(screen_tap_weight(0.0f, 3.0f), 1.0f);
  EXPECT_NEAR(screen_tap_weight(0.1f, 3.0f), 0.6f, 1e-6f);
  EXPECT_EQ(screen_tap_weight(0.25f, 20.0f), 0.0f);
  EXPECT_NEAR(screen_tap_weight(0.25f, 40.0f), 0.5f, 1e-6f);
  EXPECT_EQ(screen_tap_weight(1e30f, 40.0f), 0.0f);
}

// Of normals that turn by g a pixel along both axes the taps see more than the square of a pixel holds, in which each
// axis has g^2 / 12.
TEST(NormalVariance, ScreenShareIsThatOfAPixel) {
  constexpr double kTurn = 0.01;
  const auto tap = [](double x, double y) {
    return vec3(normalize(glm::dvec3(std::tan(kTurn * x), std::tan(kTurn * y), 1.0)));
  };
  const vec3 sum = tap(0, 0) + tap(1, 0) + tap(-1, 0) + tap(0, 1) + tap(0, -1);
  const double v = 0.5 * kScreenShare * spread2_from_screen_mean(length(sum) / 5.0f);
  EXPECT_NEAR(v, kTurn * kTurn / 12.0, 0.01 * kTurn * kTurn / 12.0);
}

TEST(NormalVariance, DielectricsAreDimmedAndMetalsAreNot) {
  // Linear luma 0.04 times (0.35 + 1e-4) / (0.7 + 1e-4); Y is its root.
  EXPECT_NEAR(square(dimmed_specular_y(0.2f, 0.7f, 0.35f)), 0.04f * 0.3501f / 0.7001f, 1e-6f);
  EXPECT_EQ(dimmed_specular_y(0.2f, 0.7f, 0.7f), 0.2f);
  EXPECT_EQ(dimmed_specular_y(0.7f, 0.7f, 0.35f), 0.7f);
}

// A lobe convolved with Gaussian normals, near the mirror direction: D at distance t of GGX of width 1 under normals of
// deviation `sigma`.
double convolved(double sigma, double t) {
  constexpr int kRings = 300, kSectors = 24;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double r = sigma * std::sqrt(-2.0 * std::log(1.0 - (i + 0.5) / kRings));
    for (int j = 0; j < kSectors; ++j) {
      const double d2 = t * t + r * r - 2.0 * t * r * std::cos(kPiExact * (j + 0.5) / kSectors);
      sum += 1.0 / ((1.0 + d2) * (1.0 + d2));
    }
  }
  return sum / (kRings * kSectors) / kPiExact;
}

// Of the light of a lobe of width 1 under normals of deviation `sigma`, how much a lobe of width sqrt(a2) puts
// elsewhere: the integral of the difference over the plane, at distances that grow by a constant ratio.
double misplaced(double sigma, double a2) {
  constexpr double kRatio = 1.08, kFarthest = 30.0;
  const double width = std::sqrt(1.0 + 2.0 * sigma * sigma);
  double sum = 0.0;
  for (double inner = 0.02 * width; inner < kFarthest * width; inner *= kRatio) {
    const double outer = kRatio * inner, t = 0.5 * (inner + outer);
    const double lobe = a2 / (kPiExact * (a2 + t * t) * (a2 + t * t));
    sum += std::abs(lobe - convolved(sigma, t)) * kPiExact * (outer * outer - inner * inner);
  }
  return sum;
}

TEST(NormalVariance, WidensSoThatLeastLightIsMisplaced) {
  struct Case {
    double sigma;          // over alpha
    double factor, least;  // the best factor to the variance, and what it leaves
  };
  constexpr double kAlpha = 0.01;
  for (const Case& c :
       {Case{0.5, 2.10, 0.113}, Case{1.0, 1.94, 0.217}, Case{2.0, 1.76, 0.298}, Case{4.0, 1.62, 0.338}}) {
    const auto spread2 = static_cast<float>(2.0 * c.sigma * c.sigma * kAlpha * kAlpha);
    const double widened =
        static_cast<double>(square(widened_alpha(static_cast<float>(kAlpha), spread2))) / (kAlpha * kAlpha);
    EXPECT_NEAR((widened - 1.0) / (c.sigma * c.sigma), c.factor, 0.06) << c.sigma;
    EXPECT_NEAR(misplaced(c.sigma, widened), c.least, 0.01) << c.sigma;
    EXPECT_GT(misplaced(c.sigma, 1.0), 1.3 * c.least) << c.sigma;
  }
}

}  // namespace
}  // namespace velarium::shading
