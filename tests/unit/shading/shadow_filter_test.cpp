#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

// The unit disc's share left of a line at x: what a filter of infinitely many taps says of the edge of a half plane.
double disc_left_of(double x) {
  const double c = std::clamp(x, -1.0, 1.0);
  return 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / kPiExact;
}

std::vector<glm::dvec2> disc_taps(std::uint32_t count, float noise = 0.0f) {
  std::vector<glm::dvec2> taps;
  vec2 direction = first_tap_direction(noise);
  for (std::uint32_t i = 0; i < count; ++i) {
    taps.push_back(glm::dvec2(direction) * static_cast<double>(disc_tap_radius(i, count)));
    direction = next_tap_direction(direction);
  }
  return taps;
}

// Share of the first m taps, scaled, that a half plane left of x hides.
double occluded(const std::vector<glm::dvec2>& taps, std::uint32_t m, double scale, double x) {
  const auto end = taps.begin() + m;
  return static_cast<double>(std::count_if(taps.begin(), end, [&](const auto& tap) { return tap.x * scale < x; })) / m;
}

// Largest error over 41 places of the edge, from -1.2 rho to 1.2 rho, as the notes on the method measure it.
double worst_error(std::uint32_t count, std::uint32_t m, double scale, double rho) {
  const auto taps = disc_taps(count);
  double worst = 0.0;
  for (int k = -20; k <= 20; ++k) {
    const double x = k / 20.0 * 1.2 * rho;
    worst = std::max(worst, std::abs(occluded(taps, m, scale, x) - disc_left_of(x / rho)));
  }
  return worst;
}

TEST(ShadowFilter, TheFirstOfSortedTapsFillASmallerDisc) {
  for (const std::uint32_t m : {1u, 2u, 4u, 8u, 16u, 32u}) {
    const double edge = std::sqrt(m / 32.0);
    const double outermost = static_cast<double>(disc_tap_radius(m - 1, 32));
    EXPECT_LT(outermost, edge);
    EXPECT_NEAR(outermost, std::sqrt((m - 0.5) / 32.0), 1e-6);
  }
  EXPECT_NEAR(disc_tap_radius(7, 32), 0.484f, 5e-4f);
}

TEST(ShadowFilter, DirectionsTurnByTheGoldenAngleAndStayUnit) {
  vec2 direction = first_tap_direction(0.0f);
  for (int i = 0; i < 64; ++i) {
    EXPECT_NEAR(direction.x, std::cos(2.39996322972865 * i), 1e-5);
    EXPECT_NEAR(direction.y, std::sin(2.39996322972865 * i), 1e-5);
    direction = next_tap_direction(direction);
  }
}

TEST(ShadowFilter, TapsBalanceAboutTheReceiver) {
  for (const float noise : {0.0f, 0.3f, 0.9f}) {
    glm::dvec2 sum(0.0);
    for (const auto& tap : disc_taps(32, noise)) sum += tap;
    EXPECT_LT(glm::length(sum) / 32.0, 0.03);
  }
}

// Of half planes, with 64 taps: the errors that the notes measured for the first m taps.
TEST(ShadowFilter, HalfPlanesHavePenumbraeOfADisc) {
  EXPECT_NEAR(worst_error(64, 64, 1.0, 1.0), 0.029, 0.002);
  EXPECT_NEAR(worst_error(64, 16, 1.0, 0.5), 0.088, 0.002);
  EXPECT_NEAR(worst_error(64, 4, 1.0, 0.25), 0.29, 0.01);
}

TEST(ShadowFilter, FewTapsAreScaledToTheWidthThatWasAskedFor) {
  for (const float rho : {0.05f, 0.25f, 0.4f, 0.5f, 0.8f, 1.0f}) {
    const std::uint32_t m = reduced_tap_count(rho, 64);
    EXPECT_GE(m, kMinShadowTaps);
    const float widest = disc_tap_radius(m - 1, 64) * reduced_tap_scale(rho, m, 64);
    EXPECT_NEAR(widest, rho * std::sqrt((static_cast<float>(m) - 0.5f) / static_cast<float>(m)), 1e-6f);
    EXPECT_LT(worst_error(64, m, static_cast<double>(reduced_tap_scale(rho, m, 64)), static_cast<double>(rho)),
              2.0 / m);
  }
}

TEST(ShadowFilter, TapsAreReducedByTheSquareOfThePenumbra) {
  EXPECT_EQ(reduced_tap_count(1.0f, 32), 32u);
  EXPECT_EQ(reduced_tap_count(0.75f, 32), 18u);
  EXPECT_EQ(reduced_tap_count(0.5f, 32), 8u);
  EXPECT_EQ(reduced_tap_count(0.0f, 32), 8u);
  EXPECT_EQ(reduced_tap_count(0.0f, 4), 4u);
}

// Half of the taps are spread evenly, so that as many lie beyond sqrt(1/2) of the radius as within; the other half
// lie within a quarter by half.
TEST(ShadowFilter, TheSearchLooksAtTheWholeDiscAndMoreAtItsMiddle) {
  int outer_half = 0, middle = 0;
  for (std::uint32_t i = 0; i < 32; ++i) {
    const float radius = search_tap_radius(i, 32, 0.0f, 1.0f);
    EXPECT_GT(radius, 0.0f);
    EXPECT_LT(radius, 1.0f);
    outer_half += i % 2 == 0 && radius > std::sqrt(0.5f) ? 1 : 0;
    middle += i % 2 == 1 && radius < 0.25f ? 1 : 0;
  }
  EXPECT_EQ(outer_half, 8);
  EXPECT_EQ(middle, 8);
  EXPECT_EQ(search_tap_radius(3, 8, 0.25f, 0.25f), 0.25f);
}

TEST(ShadowFilter, AWideSearchIsTheUsualOneWhereNothingIsWider) {
  for (std::uint32_t i = 0; i < 16; ++i)
    EXPECT_FLOAT_EQ(wide_search_tap_radius(i, 16, 0.3f, 0.3f), search_tap_radius(i, 16, 0.0f, 0.3f));
}

// A disc six times as wide as the usual one: half of the taps stay in that, the others go on to the rim in equal steps.
TEST(ShadowFilter, AWideSearchLeavesHalfOfItsTapsInTheUsualDisc) {
  int usual = 0;
  for (std::uint32_t i = 0; i < 32; ++i) usual += wide_search_tap_radius(i, 32, 1.0f, 6.0f) <= 1.0f ? 1 : 0;
  EXPECT_EQ(usual, 16 + 3);  // (i + 1/2) / 32 < 1/6 of the even ones
  EXPECT_GT(wide_search_tap_radius(30, 32, 1.0f, 6.0f), 5.5f);
  for (std::uint32_t i = 4; i < 32; i += 2)
    EXPECT_NEAR(wide_search_tap_radius(i, 32, 1.0f, 6.0f) - wide_search_tap_radius(i - 2, 32, 1.0f, 6.0f), 0.375f,
                0.2f);
}

// The penumbra of a half plane at a distance, by search and filter together: its width is linear in the distance.
TEST(ShadowFilter, PenumbraeGrowLinearlyWithTheBlockersDistance) {
  const double tangent = 0.00465, max_distance = 100.0, widest = tangent * max_distance;
  double sum_xy = 0.0, sum_xx = 0.0;
  for (double distance = 10.0; distance <= 100.0; distance += 10.0) {
    const float rho = penumbra_ratio_distant(static_cast<float>(distance), static_cast<float>(max_distance));
    const std::uint32_t m = reduced_tap_count(rho, 64);
    const double scale = static_cast<double>(reduced_tap_scale(rho, m, 64)) * widest;
    // Between 10 and 90 per cent of occlusion, over all turns of the kernel.
    double begin = 0.0, end = 0.0;
    for (int step = -600; step <= 600; ++step) {
      const double x = step * 1e-3 * widest;
      double mean = 0.0;
      for (int turn = 0; turn < 32; ++turn)
        mean += occluded(disc_taps(64, static_cast<float>(turn) / 32.0f), m, scale, 2.0 * x) / 32.0;
      if (mean < 0.1) begin = 2.0 * x;
      if (mean < 0.9) end = 2.0 * x;
    }
    sum_xy += distance * (end - begin);
    sum_xx += distance * distance;
  }
  // A disc of radius 1 lies to 10 and 90 per cent left of -0.687 and 0.687.
  EXPECT_NEAR(sum_xy / sum_xx, 2.0 * 0.687 * tangent, 0.05 * 2.0 * 0.687 * tangent);
}

TEST(ShadowFilter, LocalPenumbraeFollowSimilarTriangles) {
  EXPECT_NEAR(penumbra_radius_local(4.0f, 2.0f, 0.1f), 0.1f, 1e-7f);
  EXPECT_NEAR(penumbra_radius_local(4.0f, 1.0f, 0.1f), 0.3f, 1e-7f);
  EXPECT_EQ(penumbra_radius_local(4.0f, 4.0f, 0.1f), 0.0f);
}

// A receiver that rises steeper than the light is wide never blocks itself.
TEST(ShadowFilter, SlopesOutsideTheConeDoNotBlock) {
  const float tangent = 0.00465f;
  for (const float tilt : {10.0f, 45.0f, 80.0f, 89.0f}) {
    const float rise = std::tan(tilt * kPi / 180.0f);  // towards the light, a unit of offset
    for (const float offset : {0.05f, 0.2f, 0.4f}) EXPECT_FALSE(blocks_light(offset, rise * offset * tangent, 0.0f));
  }
  EXPECT_TRUE(blocks_light(0.04f, 10.0f * tangent, 0.0f));
  EXPECT_TRUE(blocks_light(0.01f, 0.0f, 0.015f));
}

// Two sheets that hide half of the light each, the far one its left half, the near one its lower half: a quarter is
// left. Of the near sheet's part only what the far one does not cover is seen, and half of that is lit.
TEST(ShadowFilter, RaysPassBothLayers) {
  LayeredRays rays = no_rays();
  for (int i = 0; i < 16; ++i) {
    const bool right = i % 2 == 0, up = i / 2 % 2 == 0, seen = i / 4 % 2 == 0;
    rays = with_ray(rays, right ? 1.0f : 0.0f, seen ? 1.0f : 0.0f, seen && up ? 1.0f : 0.0f);
  }
  EXPECT_NEAR(visibility_of(rays, 16u), 0.25f, 1e-6f);
}

TEST(ShadowFilter, OneLayerIsItsOwnMean) {
  LayeredRays rays = no_rays();
  for (const float past : {0.0f, 0.25f, 1.0f, 1.0f}) rays = with_ray(rays, 1.0f, 1.0f, past);
  EXPECT_NEAR(visibility_of(rays, 4u), 0.5625f, 1e-6f);
}

// A near layer that the far one hides everywhere is not there.
TEST(ShadowFilter, UnseenLayersHideNothing) {
  LayeredRays rays = no_rays();
  rays = with_ray(rays, 1.0f, 0.0f, 0.0f);
  rays = with_ray(rays, 0.0f, 0.0f, 0.0f);
  EXPECT_EQ(visibility_of(rays, 2u), 0.5f);
}

TEST(ShadowFilter, LayersArePartedBetweenTheirDistances) {
  EXPECT_FALSE(are_layered(1.0f, 2.0f));
  EXPECT_TRUE(are_layered(1.0f, 2.1f));
  for (const auto& [nearest, farthest] : {std::pair{1.0f, 3.0f}, {0.2f, 3.0f}, {0.0f, 3.0f}}) {
    EXPECT_GT(layer_split(nearest, farthest), nearest);
    EXPECT_LT(layer_split(nearest, farthest), farthest);
  }
}

}  // namespace
}  // namespace velarium::shading
