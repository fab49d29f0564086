#pragma once

#include "upload/gpu_structs.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace velarium::light_volumes {

// What is drawn for a light. The shader knows the same numbers.
enum class Shape : std::uint32_t {
  screen = 0,  // everything: lights without an end
  quad = 1,    // the part of the screen that its sphere may be seen in
  sphere = 2,  // a body around it
  cone = 3,    // the same, of narrow spots
};

// Lights [first_light, first_light + light_count), drawn in this order.
struct VolumeDraw {
  Shape shape = Shape::screen;
  std::uint32_t kind = 0;  // of all these lights: 0 directional, 1 point, 2 spot
  std::uint32_t first_light = 0, light_count = 1;
  bool marked =
      false;  // its body marks the stencil, and all of the screen is drawn where it is marked; one light alone
  bool operator==(const VolumeDraw&) const = default;
};

// How each light is drawn, by how much of the screen its sphere covers: a large one, or one that the eye is in, as body
// and screen, which finds exactly the surfaces inside; a middle one as its body, which finds those before its back; a
// small one as a quad, which needs no body. Lights that no pixel sees are left out; neighbours of one sort are one
// draw.
// bounds: upload::View::light_bounds.
[[nodiscard]] std::vector<VolumeDraw> plan(std::span<const upload::GpuLight> lights, std::span<const glm::vec4> bounds,
                                           const upload::FrameUniforms& frame);

}  // namespace velarium::light_volumes
