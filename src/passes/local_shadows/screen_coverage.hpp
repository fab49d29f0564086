#pragma once

// How much of a picture lies in a part of space.

#include "upload/view.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <span>
#include <vector>

namespace velarium::local_shadows {

// The sides of a convex solid: planes with inward normals (a point is inside where dot(n, p) + w >= 0), and on each of
// them a polygon.
struct Side {
  glm::dvec4 plane;
  std::array<glm::dvec3, 4> corners;  // a triangle has its last corner twice
};
using Solid = std::vector<Side>;

// What `view` sees up to `far` metres away from its eye, which stands at `eye`.
[[nodiscard]] Solid view_solid(const upload::ViewMatrices& view, const glm::dvec3& eye, double far);

[[nodiscard]] Solid box_solid(const glm::dvec3& low, const glm::dvec3& high);

// A pyramid: from `apex` along `axes[2]` to `reach` metres, as wide as half_tangent to the sides axes[0] and axes[1].
// The axes are unit and at right angles.
[[nodiscard]] Solid pyramid_solid(const glm::dvec3& apex, const std::array<glm::dvec3, 3>& axes, double half_tangent,
                                  double reach);

// The share of the picture, 0 to 1, that the solids' common part covers; 0 where they have none. The picture's own
// solid, view_solid(), must be among them.
[[nodiscard]] double covered_share(std::span<const Solid* const> solids, const glm::dmat4& clip_from_world);

}  // namespace velarium::local_shadows
