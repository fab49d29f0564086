#pragma once

#include "scene/scene.hpp"

namespace velarium::scene::atrium {

// A texture that is as wide as occlusion has steps: u is what is left of the sky's light. No mips.
[[nodiscard]] Image daylight_ramp();

// Gives every primitive a second uv set whose u is how much of the surroundings' light reaches each vertex, for the
// occlusion texture daylight_ramp(). Rays go to the plan's walls, roofs and floors, not to the meshes.
void measure_daylight(Scene& scene);

}  // namespace velarium::scene::atrium
