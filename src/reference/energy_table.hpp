#pragma once

#include "shading/host.hpp"

#include <span>

namespace velarium::reference {

// Directional albedo of the specular lobe, as the renderer reads it from its texture: linear between entries.
class EnergyTable {
 public:
  // size x size entries (E0, E1), which must outlive this: columns n.v, rows smoothness; size >= 2.
  EnergyTable(std::span<const glm::vec2> entries, std::uint32_t size) : entries_(entries), last_(size - 1) {}

  // Both in [0, 1].
  [[nodiscard]] glm::vec2 read(float n_dot_v, float smoothness) const {
    const float x = n_dot_v * static_cast<float>(last_), y = smoothness * static_cast<float>(last_);
    const auto column = std::min(static_cast<std::uint32_t>(x), last_ - 1);
    const auto row = std::min(static_cast<std::uint32_t>(y), last_ - 1);
    const glm::vec2* at = &entries_[std::size_t{row} * (last_ + 1) + column];
    const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
    return glm::mix(glm::mix(at[0], at[1], fx), glm::mix(at[last_ + 1], at[last_ + 2], fx), fy);
  }

 private:
  std::span<const glm::vec2> entries_;
  std::uint32_t last_;
};

}  // namespace velarium::reference
