#pragma once

// Transforms as the scene tables promise them.

#include "scene/gltf_json.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace velarium::scene::gltf {

// Throws at `at` where the last row of `matrix` is not 0 0 0 1; makes it exactly so.
template <class Matrix>
void check_affine(const Value& at, Matrix& matrix);

// glTF's (x, y, z, w) as a unit quaternion. Throws at `at` where it has no length; warns where it was not of length 1.
[[nodiscard]] glm::quat unit_rotation(const Value& at, const glm::vec4& xyzw);

}  // namespace velarium::scene::gltf
