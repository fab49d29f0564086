#pragma once

// The shape and the colours of builtin:terrain, as functions of the place. Metres; the lake's surface is at height 0.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace velarium::scene::terrain {

inline constexpr float kHalfSize = 2048.0f;

// Shapes narrower than four times `finest` are left out: a mesh with that distance between vertices cannot show them.
[[nodiscard]] float height(const glm::vec2& at, float finest);

// Linear base colour: sand at the shore, meadow, forest, rock where it is steep, snow high up.
[[nodiscard]] glm::vec3 color(const glm::vec3& position, const glm::vec3& normal);

}  // namespace velarium::scene::terrain
