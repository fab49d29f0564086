#include "passes/local_shadows/atlas_allocator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace velarium::local_shadows {
namespace {

// Marks a tile's squares of the smallest size. False where one of them is taken, or outside.
class Squares {
 public:
  Squares(std::uint32_t side, std::uint32_t unit) : unit_(unit), across_(side / unit), taken_(across_ * across_) {}

  bool mark(const Tile& tile) {
    for (std::uint32_t y = tile.y / unit_; y < (tile.y + tile.size) / unit_; ++y)
      for (std::uint32_t x = tile.x / unit_; x < (tile.x + tile.size) / unit_; ++x) {
        if (x >= across_ || y >= across_ || taken_[y * across_ + x]) return false;
        taken_[y * across_ + x] = true;
      }
    return true;
  }

 private:
  std::uint32_t unit_, across_;
  std::vector<bool> taken_;
};

std::uint64_t total_area(const std::vector<std::uint32_t>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0},
                         [](std::uint64_t sum, std::uint32_t size) { return sum + std::uint64_t{size} * size; });
}

// Mixed sizes from large to small, whose areas are the image's.
std::vector<std::uint32_t> sizes_that_fill() {
  std::vector<std::uint32_t> sizes{1024, 1024, 512, 512, 512};
  sizes.insert(sizes.end(), 12, 256);
  sizes.insert(sizes.end(), 20, 128);
  sizes.insert(sizes.end(), 16, 64);
  while (total_area(sizes) < 2048u * 2048u) sizes.push_back(32);
  return sizes;
}

TEST(ShadowTiles, AreasThatFitFindPlacesWithoutOverlap) {
  const auto sizes = sizes_that_fill();
  ASSERT_EQ(total_area(sizes), 2048u * 2048u);
  AtlasAllocator allocator(2048);
  Squares squares(2048, 32);
  for (const std::uint32_t size : sizes) {
    const auto tile = allocator.allocate(size);
    ASSERT_TRUE(tile);
    EXPECT_EQ(tile->size, size);
    EXPECT_EQ(tile->x % size, 0u);
    EXPECT_EQ(tile->y % size, 0u);
    ASSERT_TRUE(squares.mark(*tile));
  }
  EXPECT_FALSE(allocator.allocate(32));
}

TEST(ShadowTiles, WhatIsGivenBackJoinsToTheWhole) {
  AtlasAllocator allocator(1024);
  std::vector<Tile> tiles;
  while (const auto tile = allocator.allocate(64)) tiles.push_back(*tile);
  EXPECT_EQ(tiles.size(), 256u);
  // In an order of their own.
  for (std::size_t i = 0; i < tiles.size(); ++i) allocator.free(tiles[i * 37 % tiles.size()]);
  EXPECT_TRUE(allocator.allocate(1024));
}

TEST(ShadowTiles, APlaceGivenBackIsTakenAgain) {
  AtlasAllocator allocator(256);
  const auto a = allocator.allocate(128), b = allocator.allocate(128);
  ASSERT_TRUE(a && b);
  allocator.free(*a);
  EXPECT_EQ(allocator.allocate(128), a);
  EXPECT_FALSE(allocator.allocate(512));
}

TEST(ShadowTiles, SizesStayWhereTheyFit) {
  const std::vector<WantedTile> wanted{{0, 512, 1.0}, {0, 256, 1.0}, {1, 1024, 2.0}};
  EXPECT_EQ(fitting_sizes(wanted, 2048, 32), (std::vector<std::uint32_t>{512, 256, 1024}));
}

TEST(ShadowTiles, LeastImportantLightsShrinkFirst) {
  // Five of 1024^2 where there is allocator for four: the least important one alone is halved, then all are not enough.
  const std::vector<WantedTile> wanted{{0, 1024, 5.0}, {1, 1024, 1.0}, {2, 1024, 4.0}, {3, 1024, 3.0}, {4, 1024, 2.0}};
  const auto sizes = fitting_sizes(wanted, 2048, 32);
  EXPECT_EQ(sizes, (std::vector<std::uint32_t>{1024, 512, 1024, 1024, 512}));
  EXPECT_LE(total_area(sizes), 2048u * 2048u);
}

TEST(ShadowTiles, AllFacesOfALightShrinkTogether) {
  std::vector<WantedTile> wanted;
  for (int face = 0; face < 6; ++face) wanted.push_back({0, 512, 1.0});
  for (int face = 0; face < 6; ++face) wanted.push_back({1, 512, 2.0});
  const auto sizes = fitting_sizes(wanted, 1024, 32);
  EXPECT_TRUE(std::all_of(sizes.begin(), sizes.begin() + 6, [&](auto size) { return size == sizes[0]; }));
  EXPECT_TRUE(std::all_of(sizes.begin() + 6, sizes.end(), [&](auto size) { return size == sizes[6]; }));
  EXPECT_LE(sizes[0], sizes[6]);
  EXPECT_LE(total_area(sizes), 1024u * 1024u);
}

// Ten thousand lights of six faces each: more than even the smallest tiles hold.
TEST(ShadowTiles, AFullAtlasTakesShadowsFromTheLeastImportant) {
  std::vector<WantedTile> wanted;
  for (std::uint32_t light = 0; light < 10000; ++light)
    for (int face = 0; face < 6; ++face) wanted.push_back({light, 1024, 1.0 + light * 7919 % 10000});
  const auto sizes = fitting_sizes(wanted, 4096, 32);
  // 128^2 places, of which six go to each of the most important lights.
  constexpr std::size_t kLights = 128 * 128 / 6;
  EXPECT_EQ(static_cast<std::size_t>(std::count(sizes.begin(), sizes.end(), 32u)), 6 * kLights);
  double least_kept = 1e9, most_dropped = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    (sizes[i] > 0 ? least_kept : most_dropped) =
        sizes[i] > 0 ? std::min(least_kept, wanted[i].importance) : std::max(most_dropped, wanted[i].importance);
  EXPECT_GT(least_kept, most_dropped);
  AtlasAllocator allocator(4096);
  Squares squares(4096, 32);
  for (const std::uint32_t size : sizes)
    if (size > 0) {
      const auto tile = allocator.allocate(size);
      ASSERT_TRUE(tile);
      ASSERT_TRUE(squares.mark(*tile));
    }
}

}  // namespace
}  // namespace velarium::local_shadows
