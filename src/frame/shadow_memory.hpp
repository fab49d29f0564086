#pragma once

// How shadows.memory bounds the maps of a picture.

#include "passes/map_demand.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace velarium::frame {

// Maps are not made smaller than this to save memory, texels a side: six maps of the sun, a far one and an atlas, all
// with translucency, then take less than the least that shadows.memory can be.
inline constexpr int kLeastMapSide = 256;

// What all maps take. Drivers may add to align them.
[[nodiscard]] std::uint64_t map_bytes(std::span<const passes::MapDemand> demands);

struct FittedMaps {
  std::vector<passes::MapDemand> demands;  // as asked for, with the sides that fit
  std::string note;                        // which sides are others, in a sentence; empty: none
};

// Maps are halved in width and height until all fit into budget_mib together, with fixed_bytes of what cannot be made
// smaller: at each step those that take the most; of equals the first. Where all have kLeastMapSide and what is left is
// still too much, as the mask of a large picture may be, the note says so.
[[nodiscard]] FittedMaps fit_to_budget(std::span<const passes::MapDemand> wanted, std::uint64_t fixed_bytes,
                                       int budget_mib);

}  // namespace velarium::frame
