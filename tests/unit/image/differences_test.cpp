#include "metric_pictures.hpp"

#include "image/differences.hpp"

#include <cmath>
#include <limits>

namespace velarium::image {
namespace {

constexpr float kTolerance = 2.0f / 255.0f;

TEST(Differences, HalfAgainstSixTenthsIsTwentyDecibels) {
  const Differences found = differences(grey(0.5f), grey(0.6f), {}, kTolerance);
  EXPECT_NEAR(found.rmse, 0.1, 1e-7);
  EXPECT_NEAR(found.psnr_db, 20.0, 1e-5);
  EXPECT_NEAR(found.relative_mse, 0.01 / (0.36 + 0.01), 1e-7);
  EXPECT_EQ(found.share, 1.0);
  EXPECT_NEAR(found.largest, 0.1, 1e-7);
  EXPECT_EQ(found.pixels, 480u);
}

TEST(Differences, EqualPicturesHaveNone) {
  const Differences found = differences(pattern(), pattern(), {}, 0.0f);
  EXPECT_EQ(found.rmse, 0.0);
  EXPECT_EQ(found.psnr_db, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found.relative_mse, 0.0);
  EXPECT_EQ(found.share, 0.0);
  EXPECT_EQ(found.largest, 0.0);
}

TEST(Differences, OnlyTheRelativeOneDependsOnTheOrder) {
  const Differences one = differences(changed_pattern(), pattern(), {}, kTolerance);
  const Differences other = differences(pattern(), changed_pattern(), {}, kTolerance);
  EXPECT_EQ(one.rmse, other.rmse);
  EXPECT_EQ(one.share, other.share);
  EXPECT_NE(one.relative_mse, other.relative_mse);
}

TEST(Differences, AreThoseOfAnIndependentProgram) {
  const Differences found = differences(changed_pattern(), pattern(), {}, kTolerance);
  EXPECT_NEAR(found.rmse, 0.1671384, 1e-7);
  EXPECT_NEAR(found.psnr_db, 15.5384749, 1e-6);
  EXPECT_NEAR(found.relative_mse, 0.5525862, 1e-6);
}

TEST(Differences, TheShareCountsPixelsAndTheLargestHasAPlace) {
  FloatImage spotted = flat(10, 10, {0.5f, 0.5f, 0.5f});
  const FloatImage reference = spotted;
  spotted.rgba[4 * 37 + 1] += 0.25f;
  spotted.rgba[4 * 37 + 2] += 0.125f;
  spotted.rgba[4 * 80] -= 0.0625f;
  const Differences found = differences(spotted, reference, {}, 0.0625f);
  EXPECT_DOUBLE_EQ(found.share, 0.01);  // a difference that equals the tolerance is within it
  EXPECT_DOUBLE_EQ(differences(spotted, reference, {}, 0.06f).share, 0.02);
  EXPECT_DOUBLE_EQ(found.largest, 0.25);
  EXPECT_EQ(found.x, 7u);
  EXPECT_EQ(found.y, 3u);
}

TEST(Differences, AlphaCountsWhereItIsNotOpaque) {
  const FloatImage opaque = flat(4, 4, {0, 0, 0}), clear = flat(4, 4, {0, 0, 0}, 0.0f);
  EXPECT_DOUBLE_EQ(differences(opaque, clear, {}, 0.5f).rmse, 0.5);  // one channel of four
  EXPECT_DOUBLE_EQ(differences(opaque, clear, {}, 0.5f).share, 1.0);
  EXPECT_TRUE(is_opaque(opaque));
  EXPECT_FALSE(is_opaque(clear));
}

TEST(Differences, AMaskLeavesPixelsOut) {
  FloatImage changed = flat(4, 1, {0, 0, 0});
  const FloatImage reference = changed;
  for (std::size_t c = 0; c < 3; ++c) changed.rgba[c] = 1.0f;
  EXPECT_EQ(differences(changed, reference, {0, 1, 1, 1}, 0.0f).rmse, 0.0);
  const Differences found = differences(changed, reference, {1, 0, 0, 1}, 0.0f);
  EXPECT_DOUBLE_EQ(found.share, 0.5);
  EXPECT_EQ(found.pixels, 2u);
  EXPECT_DOUBLE_EQ(mean({1, 2, 3, 4}, {1, 0, 0, 1}), 2.5);
  EXPECT_DOUBLE_EQ(mean({1, 2, 3, 4}, {}), 2.5);
}

}  // namespace
}  // namespace velarium::image
