#include "scene/gltf_transforms.hpp"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <cmath>

namespace velarium::scene::gltf {

namespace {

// Files hold products of float matrices; their last row strays by rounding alone.
constexpr double kRowTolerance = 1e-4;
// Eight normalised bits: half a step, 1/254, in each of four components, lengthens by at most 2/254.
constexpr float kLengthTolerance = 0.008f;
constexpr float kSmallestLength = 1e-6f;  // below it the direction is rounding noise

}  // namespace

template <class Matrix>
void check_affine(const Value& at, Matrix& matrix) {
  using Number = typename Matrix::value_type;
  for (int column = 0; column < 4; ++column) {
    const Number wanted = column == 3 ? Number{1} : Number{0};
    if (static_cast<double>(std::abs(matrix[column][3] - wanted)) > kRowTolerance) {
      at.fail(fmt::format("element {} of a matrix is {}, must be {}: the last row is 0 0 0 1", column * 4 + 3,
                          matrix[column][3], wanted));
    }
    matrix[column][3] = wanted;
  }
}

template void check_affine(const Value&, glm::mat4&);
template void check_affine(const Value&, glm::dmat4&);

glm::quat unit_rotation(const Value& at, const glm::vec4& xyzw) {
  const float length = glm::length(xyzw);
  if (!(length > kSmallestLength) || !std::isfinite(length)) {
    at.fail(fmt::format("a rotation is a quaternion of length {}; it must be 1", length));
  }
  if (std::abs(length - 1.0f) > kLengthTolerance) at.repair("a rotation is not of unit length; it was normalised");
  const glm::vec4 unit = xyzw / length;
  return {unit.w, unit.x, unit.y, unit.z};
}

}  // namespace velarium::scene::gltf
