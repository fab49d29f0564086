#include "scene/scene.hpp"

#include <glm/common.hpp>

namespace velarium::scene {

template <class Vector>
void Box<Vector>::add(const Vector& point) {
  min = glm::min(min, point);
  max = glm::max(max, point);
}

template <class Vector>
void Box<Vector>::add(const Box& box) {
  min = glm::min(min, box.min);
  max = glm::max(max, box.max);
}

template struct Box<glm::vec3>;
template struct Box<glm::dvec3>;

// J. Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems (1990): each matrix entry moves one face.
WorldAabb transformed(const Aabb& box, const glm::dmat4& world_from_object) {
  if (box.empty()) return {};
  const glm::dvec3 place(world_from_object[3]);
  WorldAabb out{place, place};
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3 axis(world_from_object[column]);
    const glm::dvec3 a = axis * static_cast<double>(box.min[column]), b = axis * static_cast<double>(box.max[column]);
    out.min += glm::min(a, b);
    out.max += glm::max(a, b);
  }
  return out;
}

}  // namespace velarium::scene
