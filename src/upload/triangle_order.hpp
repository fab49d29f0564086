#pragma once

#include "scene/snapshot.hpp"

#include <span>
#include <vector>

namespace velarium::upload {

// Where a picture is seen from: a point, or for orthographic cameras a direction.
struct Viewpoint {
  glm::dvec3 eye{0.0};  // world space, metres
  glm::dvec3 backward{
      0.0};  // world space, unit, from what is seen to an orthographic camera; zero for perspective ones

  // Grows with the distance of what stands at `from_eye`, world space, metres from the eye.
  [[nodiscard]] double farness(const glm::dvec3& from_eye) const;
};

// The indices of a list of triangles, those whose centres are farthest from the view first; equally far ones keep
// their order. Triangles that pierce each other, or of very different size, have no right order: the one by centres
// is wrong for parts of them.
[[nodiscard]] std::vector<std::uint32_t> far_to_near(std::span<const std::uint32_t> indices,
                                                     std::span<const glm::vec3> positions,
                                                     const glm::dmat4& world_from_object, const Viewpoint& view);

}  // namespace velarium::upload
