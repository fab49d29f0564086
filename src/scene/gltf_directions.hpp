#pragma once

// Directions as files really hold them: quantised, not quite of unit length, now and then zero.

#include "scene/gltf_json.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace velarium::scene::gltf {

// Scales each to unit length; `at` is where they come from, for warnings. Normals of no length become exactly 0:
// complete_primitives() knows the triangles that stand in for them.
void make_unit_normals(const Value& at, std::vector<glm::vec3>& normals);

// The same for xyz, and a sign of +1 or -1 in w. Zero tangents become some direction across the normal.
void make_unit_tangents(const Value& at, const std::vector<glm::vec3>& normals, std::vector<glm::vec4>& tangents);

}  // namespace velarium::scene::gltf
