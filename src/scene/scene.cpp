#include "scene/scene.hpp"

#include <glm/common.hpp>

namespace velarium::scene {

void Aabb::add(const glm::vec3& point) {
  min = glm::min(min, point);
  max = glm::max(max, point);
}

void Aabb::add(const Aabb& box) {
  min = glm::min(min, box.min);
  max = glm::max(max, box.max);
}

// J. Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems (1990): each matrix entry moves one face.
Aabb Aabb::transformed(const glm::mat4& by) const {
  if (empty()) return *this;
  Aabb out{glm::vec3(by[3]), glm::vec3(by[3])};
  for (int column = 0; column < 3; ++column) {
    const glm::vec3 a = glm::vec3(by[column]) * min[column], b = glm::vec3(by[column]) * max[column];
    out.min += glm::min(a, b);
    out.max += glm::max(a, b);
  }
  return out;
}

}  // namespace velarium::scene
