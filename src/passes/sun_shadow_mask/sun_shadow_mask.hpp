#pragma once

#include "passes/contact_shadows/read.hpp"
#include "passes/gbuffer/read.hpp"
#include "passes/illumination.hpp"

namespace velarium::sun_shadow_mask {

inline constexpr const char* kMask = "sun_shadow_mask.occlusion";  // as dumps name it

// Of a picture of so many pixels.
[[nodiscard]] constexpr std::uint64_t mask_bytes(const glm::uvec2& size) {
  return std::uint64_t{4} * size.x * size.y;
}

struct Inputs {
  passes::Illumination illumination;  // of which the maps of the sun are read
  contact_shadows::Reading contact;
  graph::GraphImage normal, depth;  // of the G-buffer
};

// A picture of one float: the share of the sun that is hidden, by what the maps hold or by contact shadows, 0 where the
// surface faces away from it. Precondition: there is a sun that casts shadows.
[[nodiscard]] Reading add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::sun_shadow_mask
