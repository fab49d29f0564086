// FLIP against closed forms, and against an independent program in double precision that convolves with the whole
// two-dimensional kernels of the papers (their sections 4.1 and 4.2), on pictures made by the same formula.

#include "metric_pictures.hpp"

#include "image/differences.hpp"
#include "image/flip.hpp"
#include "image/flip_filters.hpp"
#include "image/opponent_color.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace velarium::image {
namespace {

// The papers' observer: 0.7 m from a display that is 0.7 m and 3840 pixels wide.
constexpr float kPixelsPerDegree = 3840.0f * std::numbers::pi_v<float> / 180.0f;

float sum(const Kernel& kernel) {
  return std::accumulate(kernel.taps.begin(), kernel.taps.end(), 0.0f);
}

TEST(Flip, EqualPicturesDoNotDiffer) {
  for (const float error : flip(pattern(), pattern(), kPixelsPerDegree)) EXPECT_EQ(error, 0.0f);
}

TEST(Flip, IsSymmetric) {
  const FloatImage a = to_linear(pattern()), b = to_linear(changed_pattern());
  EXPECT_EQ(flip(a, b, kPixelsPerDegree), flip(b, a, kPixelsPerDegree));
}

TEST(Flip, UniformPicturesDifferByTheirColoursAlone) {
  // Colours of a display that are farthest apart.
  for (const float error : flip(flat(8, 6, {0, 1, 0}), flat(8, 6, {0, 0, 1}), kPixelsPerDegree))
    EXPECT_NEAR(error, 1.0f, 1e-5f);
  // L* differs by 100 and nothing else does: 0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m), m the 0.7th power of the
  // distance of green and blue.
  const Lab green = hunt_lab_from_rgb({0, 1, 0}), blue = hunt_lab_from_rgb({0, 0, 1});
  const double m = std::pow(green.l - blue.l + std::hypot(green.a - blue.a, green.b - blue.b), 0.7);
  const double expected = 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * m) / (0.6 * m);
  EXPECT_NEAR(expected, 0.9673798, 1e-6);  // the independent program's
  for (const float error : flip(grey(0), grey(1), kPixelsPerDegree)) EXPECT_NEAR(error, expected, 1e-5);
  const FloatImage half = to_linear(grey(0.5f)), lighter = to_linear(grey(0.6f));
  // A feature of 1e-8, which is rounding, counts by its root.
  EXPECT_NEAR(flip(half, lighter, kPixelsPerDegree)[77], 0.2850130, 1e-4);
}

TEST(Flip, IsThatOfAnIndependentProgram) {
  const std::vector<float> errors = flip(to_linear(changed_pattern()), to_linear(pattern()), kPixelsPerDegree);
  const auto at = [&](std::size_t x, std::size_t y) { return errors[y * kPatternWidth + x]; };
  EXPECT_NEAR(mean(errors, {}), 0.2425546, 2e-6);
  EXPECT_NEAR(*std::max_element(errors.begin(), errors.end()), 0.9591213, 1e-5);
  EXPECT_NEAR(at(20, 12), 0.5302936, 1e-5);
  EXPECT_NEAR(at(20, 30), 0.3662045, 1e-5);
  EXPECT_NEAR(at(44, 20), 0.7186077, 1e-5);
  EXPECT_NEAR(at(0, 0), 0.0f, 5e-5);
}

TEST(Flip, FartherPixelsAreSmaller) {
  const std::vector<float> errors = flip(to_linear(changed_pattern()), to_linear(pattern()), 20.0f);
  EXPECT_NEAR(mean(errors, {}), 0.2166847, 2e-6);  // the independent program's
}

TEST(Flip, DoesNotDependOnHowRowsAreShared) {
  // Higher than a band, and no multiple of one.
  FloatImage a = flat(3, 131, {0.2f, 0.4f, 0.1f}), b = a;
  b.rgba[4 * (3 * 70 + 1)] = 0.9f;
  const std::vector<float> errors = flip(a, b, kPixelsPerDegree);
  // The picture is symmetric about the changed row.
  for (std::size_t distance = 1; distance < 40; ++distance)
    EXPECT_NEAR(errors[3 * (70 - distance) + 1], errors[3 * (70 + distance) + 1], 1e-5f) << distance;
  EXPECT_GT(errors[3 * 70 + 1], 0.1f);
  EXPECT_EQ(errors[3 * 10 + 1], 0.0f);
}

TEST(Flip, TakesPicturesSmallerThanItsFilters) {
  EXPECT_NEAR(flip(flat(1, 1, {0, 0, 0}), flat(1, 1, {1, 1, 1}), kPixelsPerDegree)[0], 0.9673798f, 1e-5f);
  EXPECT_GT(flip(flat(1, 1, {0, 0, 0}), flat(1, 1, {1, 1, 1}), 0.01f)[0], 0.9f);
}

TEST(FlipFilters, KeepUniformColoursAndSeeNoFeatures) {
  for (const float pixels_per_degree : {1.0f, 20.0f, kPixelsPerDegree, 500.0f}) {
    const FlipFilters filters = flip_filters(pixels_per_degree);
    EXPECT_NEAR(sum(filters.luminance), 1.0f, 1e-5f);
    EXPECT_NEAR(sum(filters.red_green), 1.0f, 1e-5f);
    EXPECT_NEAR(
        sum(filters.wide_rows) * sum(filters.wide_columns) + sum(filters.narrow_rows) * sum(filters.narrow_columns),
        1.0f, 1e-5f);
    EXPECT_NEAR(sum(filters.slope), 0.0f, 1e-5f);
    EXPECT_NEAR(sum(filters.curvature), 0.0f, 1e-5f);
  }
  EXPECT_EQ(flip_filters(kPixelsPerDegree).padding(), 10u);  // three standard deviations of blue-yellow, rounded up
}

TEST(OpponentColor, WhiteIsWhiteAndColoursComeBack) {
  const Lab white = hunt_lab_from_rgb({1, 1, 1});
  EXPECT_NEAR(white.l, 100.0f, 1e-4f);
  EXPECT_NEAR(white.a, 0.0f, 1e-3f);
  EXPECT_NEAR(white.b, 0.0f, 1e-3f);
  const Rgb back = rgb_from_opponent(opponent_from_rgb({0.1f, 0.7f, 0.3f}));
  EXPECT_NEAR(back.r, 0.1f, 1e-6f);
  EXPECT_NEAR(back.g, 0.7f, 1e-6f);
  EXPECT_NEAR(back.b, 0.3f, 1e-6f);
  // Published: L*a*b* of sRGB red under D65 is (53.24, 80.09, 67.20); chroma times L* / 100.
  const Lab red = hunt_lab_from_rgb({1, 0, 0});
  EXPECT_NEAR(red.l, 53.24f, 0.02f);
  EXPECT_NEAR(red.a, 0.5324f * 80.09f, 0.03f);
  EXPECT_NEAR(red.b, 0.5324f * 67.20f, 0.03f);
}

// Light of a wide range.
FloatImage to_light(const FloatImage& image) {
  return mapped(to_linear(image), [](float value) { return 20.0f * value * value + 0.01f; });
}

TEST(HdrFlip, ExposuresReachFromTheBrightestToTheMedian) {
  // After the curve 2.1188724 is 0.85; the pattern's light has the others from the independent program.
  const Exposures flat_light = exposures_of(grey(2.1188724f));
  EXPECT_NEAR(flat_light.first, 0.0f, 1e-5f);
  EXPECT_EQ(flat_light.count, 1);
  const Exposures exposures = exposures_of(to_light(pattern()));
  EXPECT_NEAR(exposures.first, -2.6030771f, 1e-5f);
  EXPECT_NEAR(exposures.last, 0.3869847f, 1e-5f);
  EXPECT_EQ(exposures.count, 3);
}

TEST(HdrFlip, DarknessIsSeenOnceAndBackgroundDoesNotCount) {
  EXPECT_EQ(exposures_of(grey(0)).count, 1);
  EXPECT_EQ(exposures_of(grey(-1)).count, 1);
  FloatImage mostly_dark = grey(0);
  for (std::size_t c = 0; c < 3; ++c) mostly_dark.rgba[c] = 2.1188724f;
  EXPECT_NEAR(exposures_of(mostly_dark).last, 0.0f, 1e-5f);
}

// A factor that is infinite would make black not a number, and hide what differs from it.
TEST(HdrFlip, NoLightIsTooFaintOrTooBright) {
  using Floats = std::numeric_limits<float>;
  for (const float light : {Floats::denorm_min(), Floats::min(), 1.0f, Floats::max()}) {
    const Exposures exposures = exposures_of(grey(light));
    EXPECT_TRUE(std::isfinite(std::exp2(exposures.first)) && std::isfinite(std::exp2(exposures.last))) << light;
  }
  const FloatImage faint = grey(Floats::min());
  EXPECT_GT(mean(hdr_flip(grey(0), faint, exposures_of(faint), kPixelsPerDegree), {}), 0.5);
}

TEST(HdrFlip, IsThatOfAnIndependentProgram) {
  const FloatImage picture = to_light(changed_pattern()), reference = to_light(pattern());
  const std::vector<float> errors = hdr_flip(picture, reference, exposures_of(reference), kPixelsPerDegree);
  EXPECT_NEAR(mean(errors, {}), 0.3322336, 5e-6);
  EXPECT_NEAR(*std::max_element(errors.begin(), errors.end()), 0.9642392, 1e-5);
  EXPECT_NEAR(errors[12 * kPatternWidth + 20], 0.6587169, 1e-5);
}

TEST(HdrFlip, AFactorOfLightChangesNothing) {
  const auto scaled = [](const FloatImage& image, float scale) {
    return mapped(image, [scale](float value) { return scale * value; });
  };
  const FloatImage picture = to_light(changed_pattern()), reference = to_light(pattern());
  const auto compared = [](const FloatImage& a, const FloatImage& b) {
    return mean(hdr_flip(a, b, exposures_of(b), kPixelsPerDegree), {});
  };
  EXPECT_NEAR(compared(scaled(picture, 4096.0f), scaled(reference, 4096.0f)), compared(picture, reference), 1e-5);
}

TEST(HdrFlip, HugeLightIsWhite) {
  const FloatImage huge = grey(3e38f), reference = to_light(pattern());
  for (const float error : hdr_flip(grey(3e38f), huge, {100.0f, 120.0f, 2}, kPixelsPerDegree)) EXPECT_EQ(error, 0.0f);
  EXPECT_NEAR(hdr_flip(grey(3e38f), grey(0), {20.0f, 20.0f, 1}, kPixelsPerDegree)[0], 0.9673798f, 1e-5f);
}

}  // namespace
}  // namespace velarium::image
