#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace velarium::scene {

// What the algorithm reads. Normals are unit; `indices` holds three vertices a triangle.
struct TangentInput {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::vec2> uv;
  std::span<const std::uint32_t> indices;
};

// One tangent frame a corner, in the order of `indices`, after M. Mikkelsen, "Simulation of Wrinkled Surfaces
// Revisited" (2008), with the rules of the reference implementation: an angular threshold of 180 degrees, weights by
// corner angle. xyz: unit, in the plane of the normal, towards increasing u. w: +1 or -1, so that
// w * cross(normal, tangent) points towards decreasing v, which is up in a glTF texture.
// Corners whose own triangle has no usable uv map, and that no neighbour lends one, take that of another corner of the
// same vertex, else some unit tangent in the plane of their normal (the reference gives +X there, which the normal may
// be parallel to).
[[nodiscard]] std::vector<glm::vec4> corner_tangents(const TangentInput& mesh);

}  // namespace velarium::scene
