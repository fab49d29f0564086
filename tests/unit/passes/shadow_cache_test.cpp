#include "passes/local_shadows/shadow_cache.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace velarium::local_shadows {
namespace {

// Views down from lights in a row, of equal size.
std::vector<View> views_of(std::uint32_t count, double pixels = 100.0 * 100.0) {
  std::vector<View> views;
  for (std::uint32_t i = 0; i < count; ++i)
    views.push_back({.light = i,
                     .position = {2.0 * i, 3.0, 0.0},
                     .axes = {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0)},
                     .near = 0.01,
                     .reach = 5.0,
                     .pixels = pixels,
                     .importance = 1.0 + i});
  return views;
}

class ShadowKeeper : public ::testing::Test {
 protected:
  // The maps that are drawn, by light.
  std::vector<std::uint32_t> step(const std::vector<View>& views, std::uint32_t updates, std::uint64_t shown = 1,
                                  const glm::dvec3& eye = glm::dvec3(0.0)) {
    std::vector<View> relative = views;
    for (auto& view : relative) view.position -= eye;
    placed_ = keeper_.place(relative, std::vector<std::uint64_t>(views.size(), shown), eye, settings_, updates);
    std::vector<std::uint32_t> drawn;
    for (const auto& at : placed_)
      if (at.tile && at.redraw) drawn.push_back(at.view.light);
    return drawn;
  }
  [[nodiscard]] std::size_t mapped() const {
    return static_cast<std::size_t>(
        std::count_if(placed_.begin(), placed_.end(), [](const auto& at) { return at.tile.has_value(); }));
  }
  [[nodiscard]] bool overlap() const {
    for (const auto& a : placed_)
      for (const auto& b : placed_)
        if (&a != &b && a.tile && b.tile && a.tile->x < b.tile->x + b.tile->size &&
            b.tile->x < a.tile->x + a.tile->size && a.tile->y < b.tile->y + b.tile->size &&
            b.tile->y < a.tile->y + a.tile->size)
          return true;
    return false;
  }

  ShadowCache keeper_;
  Settings settings_{};
  std::vector<PlacedView> placed_;
};

using Lights = std::vector<std::uint32_t>;

TEST_F(ShadowKeeper, NeverDrawsMoreThanItMay) {
  const auto views = views_of(7);
  EXPECT_EQ(step(views, 3).size(), 3u);
  EXPECT_EQ(mapped(), 3u);
  EXPECT_EQ(step(views, 3).size(), 3u);
  EXPECT_EQ(step(views, 3).size(), 1u);
  EXPECT_EQ(mapped(), 7u);
  EXPECT_TRUE(step(views, 3).empty());
  EXPECT_EQ(mapped(), 7u);
  EXPECT_FALSE(overlap());
}

TEST_F(ShadowKeeper, TheMostImportantLightsComeFirst) {
  EXPECT_EQ(step(views_of(5), 2), (Lights{3, 4}));
  EXPECT_EQ(step(views_of(5), 2), (Lights{1, 2}));
}

TEST_F(ShadowKeeper, WhatMovedIsDrawnAgainInTurn) {
  const auto views = views_of(4);
  EXPECT_EQ(step(views, 4).size(), 4u);
  std::vector<int> times(4);
  for (std::uint64_t picture = 2; picture < 10; ++picture)
    for (const auto light : step(views, 1, picture)) ++times[light];
  EXPECT_EQ(times, (std::vector<int>{2, 2, 2, 2}));
}

TEST_F(ShadowKeeper, MapsStayWhenTheEyeMoves) {
  const auto views = views_of(4);
  EXPECT_EQ(step(views, 4).size(), 4u);
  const auto tile = placed_[1].tile;
  EXPECT_TRUE(step(views, 4, 1, {10.0, -3.0, 7.0}).empty());
  EXPECT_EQ(placed_[1].tile, tile);
  EXPECT_NEAR(placed_[1].view.position.x, 2.0 - 10.0, 1e-12);
}

// A scene that grew moves the end of what lights reach: the map is still the one that was drawn.
TEST_F(ShadowKeeper, OldMapsKeepTheDepthThatTheyWereDrawnWith) {
  auto views = views_of(1);
  EXPECT_EQ(step(views, 1).size(), 1u);
  views[0].near = 0.02;
  EXPECT_TRUE(step(views, 1).empty());
  EXPECT_EQ(placed_[0].view.near, 0.01);
}

TEST_F(ShadowKeeper, SizesChangeOnlyByMoreThanHalfAnOctave) {
  settings_.density = 2.0f;
  EXPECT_EQ(step(views_of(1, 128.0 * 128.0), 1).size(), 1u);
  EXPECT_TRUE(step(views_of(1, 1.5 * 1.5 * 128.0 * 128.0), 1).empty());  // 0.58 octaves, which rounds to one
  EXPECT_EQ(step(views_of(1, 4.0 * 128.0 * 128.0), 1).size(), 1u);
  EXPECT_EQ(placed_[0].tile->size, 512u);
}

TEST_F(ShadowKeeper, LightsThatLeaveMakeRoom) {
  settings_.atlas = 256;
  settings_.largest = 128;
  EXPECT_EQ(step(views_of(4), 8).size(), 4u);
  const auto all = views_of(8);
  const std::vector<View> others(all.begin() + 4, all.end());
  EXPECT_EQ(step(others, 8), (Lights{4, 5, 6, 7}));
  EXPECT_FALSE(overlap());
}

TEST_F(ShadowKeeper, AFullAtlasShrinksMapsAndStaysWithinItsSides) {
  settings_.atlas = 256;
  settings_.largest = 256;
  for (const std::uint32_t lights : {1u, 3u, 9u, 40u, 90u, 5u})
    for (int picture = 0; picture < 12; ++picture) {
      (void)step(views_of(lights), 20);
      EXPECT_FALSE(overlap());
      for (const auto& at : placed_)
        if (at.tile) { EXPECT_LE(std::max(at.tile->x, at.tile->y) + at.tile->size, 256u); }
    }
  EXPECT_EQ(mapped(), 5u);
}

}  // namespace
}  // namespace velarium::local_shadows
