// shadows.memory: which maps get smaller, and that they fit. Numbers are texels times bytes, by hand.

#include "frame/shadow_memory.hpp"

#include <velarium/settings.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace velarium::frame {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

// In the order in which equals are halved. Four maps of the sun of 2048^2 texels, 12 bytes each: 192 MiB. An atlas of
// 4096^2, 12 bytes: 192 MiB. A far map of 2048^2, 20 bytes while it is drawn: 80 MiB.
std::vector<passes::MapDemand> all_maps(std::uint64_t sun_maps = 4) {
  return {{"far.size", 2048, 20}, {"atlas.size", 4096, 12}, {"sun.size", 2048, 12 * sun_maps}};
}

std::vector<int> sides_of(const FittedMaps& fitted) {
  std::vector<int> sides;
  for (const auto& maps : fitted.demands) sides.push_back(maps.side);
  return sides;
}

using Sides = std::vector<int>;

TEST(ShadowMemory, IsTexelsTimesBytes) {
  EXPECT_EQ(map_bytes(all_maps()), 464 * kMiB);
  EXPECT_EQ(map_bytes(std::vector<passes::MapDemand>{{"", 8192, 2}}), 128 * kMiB);
  EXPECT_EQ(map_bytes(std::vector<passes::MapDemand>{{"", 4096, 0}}), 0u);
  EXPECT_EQ(map_bytes({}), 0u);
}

TEST(ShadowMemory, DefaultsFit) {
  const Settings settings;
  const std::vector<passes::MapDemand> demands{{"", settings.far_shadows.static_size, 2},
                                               {"", settings.local_shadows.atlas, 12},
                                               {"", settings.sun_shadows.size, 4 * 12}};
  EXPECT_EQ(fit_to_budget(demands, std::uint64_t{4} * 3840 * 2160, settings.shadows.memory).note, "");
}

TEST(ShadowMemory, WhatFitsStays) {
  const auto fitted = fit_to_budget(all_maps(), 0, 464);
  EXPECT_EQ(sides_of(fitted), (Sides{2048, 4096, 2048}));
  EXPECT_EQ(fitted.note, "");
}

TEST(ShadowMemory, TheLargestAreHalvedInTurn) {
  // Atlas and sun take 192 each, the atlas is first: 80 + 48 + 192.
  EXPECT_EQ(sides_of(fit_to_budget(all_maps(), 0, 463)), (Sides{2048, 2048, 2048}));
  // Then the sun: 80 + 48 + 48.
  EXPECT_EQ(sides_of(fit_to_budget(all_maps(), 0, 256)), (Sides{2048, 2048, 1024}));
  // Then the far map and the atlas: 20 + 12 + 48.
  EXPECT_EQ(sides_of(fit_to_budget(all_maps(), 0, 100)), (Sides{1024, 1024, 1024}));
}

// 8192^2 texels of two bytes and two maps of 4096^2 of four are 128 MiB each.
TEST(ShadowMemory, TheFirstGoesBeforeItsEquals) {
  const std::vector<passes::MapDemand> demands{{"", 8192, 2}, {"", 4096, 8}};
  EXPECT_EQ(sides_of(fit_to_budget(demands, 0, 255)), (Sides{4096, 4096}));
}

TEST(ShadowMemory, TheNoteSaysWhatIsSmaller) {
  EXPECT_EQ(fit_to_budget(all_maps(), 0, 256).note,
            "atlas.size is 2048 instead of 4096, sun.size is 1024 instead of 2048: shadows.memory=256 allows no more");
}

TEST(ShadowMemory, WhatIsNotNeededIsNotTouched) {
  const std::vector<passes::MapDemand> demands{{"", 2048, 0}, {"", 4096, 0}, {"", 2048, 4}};
  EXPECT_EQ(sides_of(fit_to_budget(demands, 0, 8)), (Sides{2048, 4096, 1024}));
}

TEST(ShadowMemory, EveryBudgetIsKept) {
  for (const int size : {16384, 10000, 300}) {
    Sides before{0, 0, 0};
    for (int memory = 8; memory < 40000; memory += 1 + memory / 3) {
      auto demands = all_maps(6);
      demands[0].side = size / 2;
      demands[1].side = demands[2].side = size;
      const auto fitted = fit_to_budget(demands, 0, memory);
      EXPECT_LE(map_bytes(fitted.demands), static_cast<std::uint64_t>(memory) * kMiB) << size << ' ' << memory;
      const Sides sides = sides_of(fitted);
      for (std::size_t i = 0; i < sides.size(); ++i)
        EXPECT_GE(sides[i], before[i]) << "more memory, smaller maps: " << size << ' ' << memory;
      before = sides;
    }
  }
}

// A mask of a picture of 32 megapixels alone takes more.
TEST(ShadowMemory, AMaskThatDoesNotFitIsSaid) {
  const auto fitted = fit_to_budget(all_maps(), 128 * kMiB, 64);
  EXPECT_EQ(sides_of(fitted), (Sides{kLeastMapSide, kLeastMapSide, kLeastMapSide}));
  EXPECT_NE(fitted.note.find("more than shadows.memory=64"), std::string::npos) << fitted.note;
}

TEST(ShadowMemory, SmallMapsStay) {
  auto demands = all_maps();
  demands[1].side = 256;
  demands[2].side = 64;
  EXPECT_EQ(sides_of(fit_to_budget(demands, 0, 8)), (Sides{512, 256, 64}));  // 5 + 0.75 + 0.19 MiB
}

}  // namespace
}  // namespace velarium::frame
