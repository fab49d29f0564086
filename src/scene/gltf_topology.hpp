#pragma once

// Strips, fans and loops as lists.

#include "scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace velarium::scene::gltf {

// mesh.primitive.mode, with its values.
enum class Mode : std::uint8_t {
  points = 0,
  lines = 1,
  line_loop = 2,
  line_strip = 3,
  triangles = 4,
  triangle_strip = 5,
  triangle_fan = 6
};

[[nodiscard]] Topology topology_of(Mode mode);

// Indices of the same points, lines or triangles as a list, in the order and winding of glTF 2.0, 3.7.2.1.
// Those left over at the end, which make no whole line or triangle, are dropped; empty where all are.
[[nodiscard]] std::vector<std::uint32_t> as_list(Mode mode, std::vector<std::uint32_t> indices);

// How many indices as_list() drops of `count`.
[[nodiscard]] std::size_t left_over(Mode mode, std::size_t count);

}  // namespace velarium::scene::gltf
