#include "bench_compare.hpp"
#include "bench_statistics.hpp"
#include "bench_sweep.hpp"

#include <velarium/error.hpp>
#include <velarium/median.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace velarium::app {
namespace {

TEST(Statistics, MediansAreTheMiddle) {
  EXPECT_EQ(median<double>({}), 0.0);
  EXPECT_EQ(median<double>({3}), 3.0);
  EXPECT_EQ(median<double>({9, 1, 4}), 4.0);
  EXPECT_EQ(median<double>({9, 1, 4, 2}), 3.0);
  EXPECT_EQ(median_absolute_deviation({1, 1, 2, 2, 4, 6, 9}), 1.0);  // distances from 2: 1 1 0 0 2 4 7
  EXPECT_EQ(median_absolute_deviation({5, 5, 5, 1000}), 0.0);
}

TEST(PowerFit, FindsTheExponentOfAPower) {
  for (const double exponent : {-1.0, 0.0, 0.5, 2.0}) {
    std::vector<double> x, y;
    for (const double v : {1.0, 3.0, 10.0, 700.0}) {
      x.push_back(v);
      y.push_back(4.2 * std::pow(v, exponent));
    }
    const auto fit = fit_power(x, y);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->exponent, exponent, 1e-12);
    EXPECT_NEAR(fit->standard_error.value(), 0.0, 1e-6);
  }
}

// Of y = 0, 0, 1 over x = 0, 1, 2 in logarithms: slope 1/2, squared residuals sum to 1/6, so that the standard error is
// sqrt((1/6) / 1 / 2) = sqrt(1/12).
TEST(PowerFit, HasTheStandardErrorOfAStraightLine) {
  const double e = std::exp(1.0);
  const auto fit = fit_power(std::vector{1.0, e, e * e}, std::vector{1.0, 1.0, e});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->exponent, 0.5, 1e-12);
  EXPECT_NEAR(fit->standard_error.value(), std::sqrt(1.0 / 12.0), 1e-12);
}

TEST(PowerFit, RefusesWhatHasNoLogarithmOrNoSlope) {
  EXPECT_FALSE(fit_power(std::vector{1.0, 2.0}, std::vector{1.0, 0.0}));
  EXPECT_FALSE(fit_power(std::vector{0.0, 2.0}, std::vector{1.0, 1.0}));
  EXPECT_FALSE(fit_power(std::vector{2.0, 2.0}, std::vector{1.0, 3.0}));
  EXPECT_FALSE(fit_power(std::vector{1.0, 2.0}, std::vector{1.0, std::nan("")}));
  EXPECT_FALSE(fit_power({}, {}));
  EXPECT_FALSE(fit_power(std::vector{1.0, 2.0}, std::vector{1.0, 2.0})->standard_error);
}

TEST(Samples, KeepWhatShadowMapsTake) {
  RenderReport report;
  report.shadow_maps = {{"local_shadows.atlas", 4096}};
  Samples samples;
  samples.add(report, {});
  samples.add(report, {});
  const auto json = json_of(samples.figures());
  ASSERT_EQ(json.at("shadow_maps").size(), 1u);
  EXPECT_EQ(json.at("shadow_maps")[0].at("name"), "local_shadows.atlas");
  EXPECT_EQ(json.at("shadow_maps")[0].at("bytes"), 4096);
}

Figures figures(const char* scene, std::vector<Interval> intervals) {
  Figures f;
  f.scene = scene;
  f.width = 64;
  f.height = 36;
  f.intervals = std::move(intervals);
  return f;
}

TEST(Compare, MarksWhatIsBeyondTheNoise) {
  // Noise of 3 and 4 together: 5 x 1.4826 x 2 = 14.826.
  const auto change = [](double now) { return Change{"s", {"a", 100, 3}, {"a", now, 4}}; };
  EXPECT_FALSE(change(114.8).beyond_noise());
  EXPECT_TRUE(change(114.9).beyond_noise());
  EXPECT_TRUE(change(85.1).beyond_noise());
  EXPECT_DOUBLE_EQ(change(125).ratio(), 1.25);
}

TEST(Compare, TakesWhatBothHave) {
  const std::vector before{figures("a", {{"x", 1, 0}, {"gone", 1, 0}, {"nothing", 0, 0}}), figures("b", {{"x", 1, 0}})};
  const std::vector after{figures("a", {{"new", 1, 0}, {"x", 3, 0}, {"nothing", 1, 0}}), figures("c", {{"x", 1, 0}})};
  const std::vector<Change> all = changes(before, after);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].after.name, "x");
  EXPECT_NO_THROW(check_changes(all, 3.0));
  try {
    check_changes(all, 2.9);
    FAIL();
  } catch (const Error& error) { EXPECT_EQ(error.code(), ErrorCode::comparison_differs); }
}

TEST(Compare, SizesTellScenesApart) {
  std::vector before{figures("a", {{"x", 1, 0}})}, after = before;
  after[0].width = 65;
  EXPECT_TRUE(changes(before, after).empty());
}

TEST(Sweep, ResolutionKeepsTheShapeAndFitsPixels) {
  const auto points = points_of(find_sweep("resolution"), {9, 18}, "s.glb", 1280, 720);
  EXPECT_EQ(points[0].width, 16u);
  EXPECT_EQ(points[1].height, 18u);
  EXPECT_EQ(points[1].x, 32.0 * 18.0);
  EXPECT_EQ(points[1].scene, "s.glb");
}

TEST(Sweep, GrowthIsOfIntervalsThatEveryPointHas) {
  const auto points = points_of(find_sweep("lights"), {1, 10, 100}, "", 64, 36);
  EXPECT_EQ(points[2].scene, "builtin:atrium?sun=off&lights=100");
  const std::vector all{figures("", {{"a", 2, 0}, {"b", 1, 0}, {"idle", 0, 0}}),
                        figures("", {{"a", 20, 0}, {"idle", 0, 0}}),
                        figures("", {{"b", 1, 0}, {"a", 200, 0}, {"idle", 0, 0}})};
  const auto growth = growth_of(points, all);
  ASSERT_EQ(growth.size(), 1u);
  EXPECT_EQ(growth[0].name, "a");
  EXPECT_DOUBLE_EQ(growth[0].ratio, 100.0);
  EXPECT_NEAR(growth[0].exponent.value(), 1.0, 1e-12);
  EXPECT_EQ(csv_of(points, growth),
            "name,1,10,100,growth,exponent,standard_error\n"
            "a,2.0000,20.0000,200.0000,100.0000,1.000,0.000\n");
}

TEST(Sweep, PointsRise) {
  EXPECT_EQ(parse_sweep_points("1,20"), (std::vector<std::uint32_t>{1, 20}));
  for (const char* wrong : {"", "1", "1,", "2,1", "1,1", "0,1", "1,x"})
    EXPECT_THROW((void)parse_sweep_points(wrong), Error);
}

}  // namespace
}  // namespace velarium::app
