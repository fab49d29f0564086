// The metric is tested before pictures are trusted to it.

#include "support/metric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace velarium::test {
namespace {

// A ramp, so that it is not taken for a blank picture.
image::ByteImage ramp(std::uint32_t width, std::uint32_t height, int shift) {
  image::ByteImage image{width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const auto value = static_cast<std::uint8_t>(100 + static_cast<int>(i % 8) + shift);
    image.rgba.insert(image.rgba.end(), {value, value, value, 255});
  }
  return image;
}

constexpr Tolerance kNone{.max_error = 0, .share = 0.0};

TEST(Metric, IdenticalPicturesAreTheSame) {
  const Verdict verdict = compare(ramp(16, 8, 0), ramp(16, 8, 0), kNone);
  EXPECT_TRUE(verdict.same) << verdict.says;
  EXPECT_EQ(verdict.worst, 0);
  EXPECT_EQ(verdict.share, 0.0);
}

TEST(Metric, HalfAgainstSixTenthsDiffersEverywhere) {
  // As 8 bits hold them: 128 and 153.
  const Verdict verdict = compare(ramp(16, 8, 25), ramp(16, 8, 0), {});
  EXPECT_FALSE(verdict.same);
  EXPECT_EQ(verdict.worst, 25);
  EXPECT_EQ(verdict.share, 1.0);
}

TEST(Metric, ErrorsUpToTheLimitAreAllowed) {
  EXPECT_TRUE(compare(ramp(16, 8, 2), ramp(16, 8, 0), {.max_error = 2, .share = 0.0}).same);
  EXPECT_FALSE(compare(ramp(16, 8, 3), ramp(16, 8, 0), {.max_error = 2, .share = 0.0}).same);
}

TEST(Metric, OnlyTheShareMayExceedTheLimit) {
  auto spotted = ramp(10, 10, 0);
  spotted.rgba[4] = 255;
  EXPECT_TRUE(compare(spotted, ramp(10, 10, 0), {.max_error = 2, .share = 0.01}).same);
  spotted.rgba[8] = 255;
  const Verdict verdict = compare(spotted, ramp(10, 10, 0), {.max_error = 2, .share = 0.01});
  EXPECT_FALSE(verdict.same);
  EXPECT_DOUBLE_EQ(verdict.share, 0.02);
}

TEST(Metric, AlphaCounts) {
  auto clear = ramp(16, 8, 0);
  clear.rgba[3] = 0;
  EXPECT_FALSE(compare(clear, ramp(16, 8, 0), kNone).same);
}

TEST(Metric, ABlankPictureFails) {
  const image::ByteImage blank{16, 8, std::vector<std::uint8_t>(std::size_t{4} * 16 * 8, 0)};
  EXPECT_FALSE(compare(blank, ramp(16, 8, 0), {.max_error = 255, .share = 1.0}).same);
  EXPECT_FALSE(compare(blank, blank, {}).same);
}

TEST(Metric, AnotherSizeFails) {
  EXPECT_FALSE(compare(ramp(16, 8, 0), ramp(8, 16, 0), {.max_error = 255, .share = 1.0}).same);
}

TEST(Metric, DifferencePicturesShowWhatDiffers) {
  auto changed = ramp(16, 8, 0);
  changed.rgba[0] += 3;
  const auto shown = difference_picture(changed, ramp(16, 8, 0));
  EXPECT_EQ(shown.rgba[0], 48);
  EXPECT_EQ(shown.rgba[1], 0);
  EXPECT_EQ(shown.rgba[3], 255);
}

TEST(FloatMetric, TheLargestErrorIsFoundWhereverItIs) {
  const std::vector<float> a(400, 0.5f);
  std::vector<float> b = a;
  EXPECT_EQ(largest_error(a, b), 0.0);
  b[399] = 0.25f;
  b[3] = 0.625f;
  EXPECT_EQ(largest_error(a, b), 0.25);
  EXPECT_EQ(largest_error(b, a), 0.25);
}

TEST(FloatMetric, NotANumberFails) {
  const std::vector<float> a(400, 0.5f);
  std::vector<float> b = a;
  b[17] = std::numeric_limits<float>::quiet_NaN();
  for (const double error : {largest_error(a, b), largest_error(b, a), largest_error(b, b)})
    EXPECT_TRUE(std::isnan(error));
}

TEST(FloatMetric, AnotherSizeOrNoValueFails) {
  EXPECT_TRUE(std::isnan(largest_error(std::vector<float>(4, 0.5f), std::vector<float>(8, 0.5f))));
  EXPECT_TRUE(std::isnan(largest_error({}, {})));
}

}  // namespace
}  // namespace velarium::test
