#include "passes/local_shadows/atlas_allocator.hpp"

#include "core/assert.hpp"

#include <algorithm>
#include <bit>

namespace velarium::local_shadows {
namespace {

// Every second bit of a place along the Z-order curve is the one coordinate, the others are the other [Morton 1966].
std::uint32_t even_bits(std::uint32_t x) {
  x &= 0x55555555u;
  x = (x | (x >> 1u)) & 0x33333333u;
  x = (x | (x >> 2u)) & 0x0f0f0f0fu;
  x = (x | (x >> 4u)) & 0x00ff00ffu;
  return (x | (x >> 8u)) & 0x0000ffffu;
}

std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | (x << 8u)) & 0x00ff00ffu;
  x = (x | (x << 4u)) & 0x0f0f0f0fu;
  x = (x | (x << 2u)) & 0x33333333u;
  return (x | (x << 1u)) & 0x55555555u;
}

// Views [first, end) of one light.
struct Range {
  std::size_t first, end;
  double importance;
};

// The least important first. Equals: the later in the scene is the less important.
std::vector<Range> lights_of(std::span<const WantedTile> wanted) {
  std::vector<Range> lights;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i == 0 || wanted[i].light != wanted[i - 1].light) lights.push_back({i, i, wanted[i].importance});
    lights.back().end = i + 1;
  }
  std::stable_sort(lights.begin(), lights.end(),
                   [](const Range& a, const Range& b) { return a.importance > b.importance; });
  std::reverse(lights.begin(), lights.end());
  return lights;
}

std::uint64_t area(std::uint32_t size) {
  return std::uint64_t{size} * size;
}

}  // namespace

AtlasAllocator::AtlasAllocator(std::uint32_t side) : side_(side) {
  VEL_ASSERT(std::has_single_bit(side));
  free_.resize(static_cast<std::size_t>(std::countr_zero(side)) + 1);
  free_.front().insert(0);
}

std::size_t AtlasAllocator::level_of(std::uint32_t size) const {
  VEL_ASSERT(std::has_single_bit(size));
  return free_.size() - 1 - static_cast<std::size_t>(std::countr_zero(size));
}

std::optional<Tile> AtlasAllocator::allocate(std::uint32_t size) {
  if (size > side_) return std::nullopt;
  const std::size_t wanted = level_of(size);
  std::size_t level = wanted;
  while (free_[level].empty())
    if (level-- == 0) return std::nullopt;
  std::uint32_t place = free_[level].extract(free_[level].begin()).value();
  for (; level < wanted; ++level) {
    place *= 4;
    for (std::uint32_t quarter = 1; quarter < 4; ++quarter) free_[level + 1].insert(place + quarter);
  }
  return Tile{even_bits(place) * size, even_bits(place >> 1u) * size, size};
}

void AtlasAllocator::free(const Tile& tile) {
  std::size_t level = level_of(tile.size);
  std::uint32_t place = spread_bits(tile.x / tile.size) | spread_bits(tile.y / tile.size) << 1u;
  free_[level].insert(place);
  for (; level > 0; --level, place /= 4) {
    const std::uint32_t first = place & ~3u;
    auto& free = free_[level];
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
      if (!free.contains(first + quarter)) return;
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter) free.erase(first + quarter);
    free_[level - 1].insert(place / 4);
  }
}

std::vector<std::uint32_t> fitting_sizes(std::span<const WantedTile> wanted, std::uint32_t side,
                                         std::uint32_t smallest) {
  std::vector<std::uint32_t> sizes;
  std::uint64_t total = 0;
  for (const auto& tile : wanted) {
    sizes.push_back(std::clamp(tile.size, smallest, side));
    total += area(sizes.back());
  }
  const std::vector<Range> lights = lights_of(wanted);
  const auto change = [&](const Range& light, auto new_size) {
    bool changed = false;
    for (std::size_t i = light.first; i < light.end; ++i) {
      const std::uint32_t size = new_size(sizes[i]);
      changed |= size != sizes[i];
      total -= area(sizes[i]) - area(size);
      sizes[i] = size;
    }
    return changed;
  };
  for (bool changed = true; changed && total > area(side);) {
    changed = false;
    for (const Range& light : lights) {
      if (total <= area(side)) break;
      changed |= change(light, [&](std::uint32_t size) { return std::max(size / 2, smallest); });
    }
  }
  for (const Range& light : lights) {
    if (total <= area(side)) break;
    change(light, [](std::uint32_t) { return 0u; });
  }
  return sizes;
}

}  // namespace velarium::local_shadows
