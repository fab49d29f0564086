#include "frame/shadow_memory.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace velarium::frame {
namespace {

using passes::MapDemand;

std::uint64_t bytes_of(const MapDemand& maps) {
  return static_cast<std::uint64_t>(maps.side) * static_cast<std::uint64_t>(maps.side) * maps.texel_bytes;
}

std::uint64_t savable_bytes(const MapDemand& maps) {
  return maps.side > kLeastMapSide ? bytes_of(maps) : 0;
}

std::string note_of(std::span<const MapDemand> wanted, std::span<const MapDemand> fitted, int budget_mib) {
  std::string changes;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (fitted[i].side != wanted[i].side)
      changes += fmt::format("{}{} is {} instead of {}", changes.empty() ? "" : ", ", fitted[i].option, fitted[i].side,
                             wanted[i].side);
  return changes.empty() ? changes : fmt::format("{}: shadows.memory={} allows no more", changes, budget_mib);
}

}  // namespace

std::uint64_t map_bytes(std::span<const MapDemand> demands) {
  std::uint64_t bytes = 0;
  for (const auto& maps : demands) bytes += bytes_of(maps);
  return bytes;
}

FittedMaps fit_to_budget(std::span<const MapDemand> wanted, std::uint64_t fixed_bytes, int budget_mib) {
  FittedMaps fitted{{wanted.begin(), wanted.end()}, {}};
  const std::uint64_t budget = static_cast<std::uint64_t>(budget_mib) << 20u;
  while (map_bytes(fitted.demands) + fixed_bytes > budget) {
    auto& most = *std::ranges::max_element(fitted.demands, {}, savable_bytes);
    if (savable_bytes(most) == 0) break;
    most.side = std::max(most.side / 2, kLeastMapSide);
  }
  fitted.note = note_of(wanted, fitted.demands, budget_mib);
  if (const auto bytes = map_bytes(fitted.demands) + fixed_bytes; bytes > budget)
    fitted.note += fmt::format("{}shadows take {} MiB, more than shadows.memory={}, in a picture as large as this",
                               fitted.note.empty() ? "" : "; ", bytes >> 20u, budget_mib);
  return fitted;
}

}  // namespace velarium::frame
