#pragma once

// Room for square tiles in a square image.

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace velarium::local_shadows {

// Place of a tile: its upper left corner, and its side, texels.
struct Tile {
  std::uint32_t x = 0, y = 0, size = 0;
  bool operator==(const Tile&) const = default;
};

// A quadtree of free squares. Sides are powers of two. Tiles asked for from the largest to the smallest leave no gap:
// they fit if their areas do.
class AtlasAllocator {
 public:
  explicit AtlasAllocator(std::uint32_t side);

  // The free place that comes first along the Z-order curve; nothing where no square of this size is free.
  [[nodiscard]] std::optional<Tile> allocate(std::uint32_t size);
  void free(const Tile& tile);

 private:
  [[nodiscard]] std::size_t level_of(std::uint32_t size) const;

  std::uint32_t side_;
  std::vector<std::set<std::uint32_t>> free_;  // by level, 0 the whole image: places along the Z-order curve
};

// What views ask for. All views of a light fare alike.
struct WantedTile {
  std::uint32_t light = 0;  // of one light beside each other
  std::uint32_t size = 0;   // a power of two
  double importance = 0.0;  // of the light
};

// Sizes that fit into an image of side^2 texels together: as wanted, where they do. Else tiles are halved, those of the
// least important light first, once each, then again from the least important on, until the rest fits. Where all are
// `smallest` and still too many, the least important lights get none: 0.
[[nodiscard]] std::vector<std::uint32_t> fitting_sizes(std::span<const WantedTile> wanted, std::uint32_t side,
                                                       std::uint32_t smallest);

}  // namespace velarium::local_shadows
