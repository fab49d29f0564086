#include "passes/local_shadows/nearest_caster.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace velarium::local_shadows {
namespace {

using glm::vec3;
using Triangle = std::array<vec3, 3>;

float squared(const vec3& v) {
  return glm::dot(v, v);
}

// Of the origin from a box, as all distances here.
float squared_distance(const vec3& low, const vec3& high) {
  return squared(glm::max(glm::max(low, -high), vec3(0.0f)));
}

float squared_distance_to_edge(const vec3& a, const vec3& b) {
  const vec3 edge = b - a;
  const float length2 = squared(edge);
  const float along = length2 > 0.0f ? std::clamp(-glm::dot(a, edge) / length2, 0.0f, 1.0f) : 0.0f;
  return squared(a + along * edge);
}

// The origin's foot on the plane where that lies inside, else the nearest of the edges.
float squared_distance(const Triangle& t) {
  const vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const auto is_inside = [&](int i) {
    const vec3 &from = t[static_cast<std::size_t>(i)], &to = t[static_cast<std::size_t>((i + 1) % 3)];
    return glm::dot(glm::cross(to - from, -from), normal) >= 0.0f;
  };
  const float area2 = squared(normal);
  if (area2 > 0.0f && is_inside(0) && is_inside(1) && is_inside(2)) {
    const float off = glm::dot(t[0], normal);
    return off * off / area2;
  }
  return std::min({squared_distance_to_edge(t[0], t[1]), squared_distance_to_edge(t[1], t[2]),
                   squared_distance_to_edge(t[2], t[0])});
}

// The least of `best` and the squared distances of the caster's triangles; gives up looking at `enough`.
float squared_distance(const upload::Caster& caster, const upload::ObjectData& object, const vec3& position, float best,
                       float enough) {
  const auto place = [&](std::uint32_t index) {
    const glm::vec4 p(caster.positions[index], 1.0f);
    return vec3(glm::dot(object.world_from_object[0], p), glm::dot(object.world_from_object[1], p),
                glm::dot(object.world_from_object[2], p)) -
           position;
  };
  for (std::size_t i = 0; i + 2 < caster.indices.size() && best > enough; i += 3) {
    const Triangle t{place(caster.indices[i]), place(caster.indices[i + 1]), place(caster.indices[i + 2])};
    const vec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
    if (squared_distance(low, high) < best) best = std::min(best, squared_distance(t));
  }
  return best;
}

}  // namespace

double nearest_caster(const upload::CasterTable& table, const glm::dvec3& origin, const glm::dvec3& position,
                      double nearest, double farthest, bool translucent) {
  const auto enough = static_cast<float>(nearest * nearest);
  auto best = static_cast<float>(farthest * farthest);
  std::vector<std::pair<float, std::size_t>> boxes;  // nearest first: most others need no look at their triangles
  for (std::size_t i = 0; i < table.casters.size(); ++i) {
    const auto& caster = table.casters[i];
    if (caster.kind == upload::CasterKind::translucent && !translucent) continue;
    const glm::dvec3 from = origin + position;
    const float box = squared_distance(vec3(caster.bounds.min - from), vec3(caster.bounds.max - from));
    if (box < best) boxes.emplace_back(box, i);
  }
  std::sort(boxes.begin(), boxes.end());
  for (const auto& [box, i] : boxes) {
    if (box >= best || best <= enough) break;
    const auto& caster = table.casters[i];
    best = caster.indices.empty() ? box : squared_distance(caster, table.objects[i], vec3(position), best, enough);
  }
  return std::clamp(std::sqrt(static_cast<double>(best)), nearest, farthest);
}

}  // namespace velarium::local_shadows
