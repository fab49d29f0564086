#include "scene/tangents.hpp"

#include "core/assert.hpp"
#include "scene/tangents_split.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace velarium::scene {
namespace {

// A triangle without area has no normal and draws nothing: any unit vector keeps later maths finite.
constexpr glm::vec3 kNormalOfNothing{0.0f, 1.0f, 0.0f};

// In double, because the squared edges of a triangle smaller than 1e-10 m underflow in float.
glm::dvec3 twice_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

glm::vec3 unit_or_any(const glm::dvec3& area) {
  const double length = glm::length(area);
  return length > 0.0 ? glm::vec3(area / length) : kNormalOfNothing;
}

glm::vec3 face_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return unit_or_any(twice_area(a, b, c));
}

std::vector<glm::vec3> face_normals(const std::vector<glm::vec3>& corners) {
  std::vector<glm::vec3> normals(corners.size());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    normals[i] = normals[i + 1] = normals[i + 2] = face_normal(corners[i], corners[i + 1], corners[i + 2]);
  }
  return normals;
}

// What takes the flat normal at rest to the flat normal of the fully morphed triangle: exact at weights 0 and 1.
std::vector<glm::vec3> normal_displacements(const VertexFrames& rest, const std::vector<glm::vec3>& displacements) {
  std::vector<glm::vec3> moved(rest.positions);
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += displacements[i];
  std::vector<glm::vec3> normals = face_normals(moved);
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] -= rest.normals[i];
  return normals;
}

}  // namespace

void make_flat_normals(Primitive& primitive) {
  VEL_ASSERT(primitive.topology == Topology::triangles && primitive.vertices.normals.empty());
  const std::vector<std::uint32_t> sources = std::move(primitive.indices);
  gather_vertices(primitive, sources);
  primitive.indices.resize(sources.size());
  std::iota(primitive.indices.begin(), primitive.indices.end(), 0u);
  primitive.vertices.normals = face_normals(primitive.vertices.positions);
  for (MorphTarget& target : primitive.morph_targets) {
    target.normals.clear();
    if (!target.positions.empty()) target.normals = normal_displacements(primitive.vertices, target.positions);
  }
}

void fill_zero_normals(Primitive& primitive) {
  auto& [positions, normals, tangents] = primitive.vertices;
  if (std::ranges::find(normals, glm::vec3(0.0f)) == normals.end()) return;
  std::vector<glm::dvec3> areas(normals.size(), glm::dvec3(0.0));
  const std::vector<std::uint32_t>& corners = primitive.indices;
  for (std::size_t i = 0; primitive.topology == Topology::triangles && i + 2 < corners.size(); i += 3) {
    const glm::dvec3 area = twice_area(positions[corners[i]], positions[corners[i + 1]], positions[corners[i + 2]]);
    for (std::size_t corner = i; corner < i + 3; ++corner) areas[corners[corner]] += area;
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (normals[i] == glm::vec3(0.0f)) normals[i] = unit_or_any(areas[i]);
}

}  // namespace velarium::scene
