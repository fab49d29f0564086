#include "reference/objects.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace velarium::reference {
namespace {

// A position goes through about a dozen sums and products of coordinates, here and in Embree, each of which may round
// by 2^-24 of the largest: 2^-20 of it covers them.
constexpr float kRounding = 0x1p-20f;

float inverse_scale_of(const glm::mat3& turn) {
  constexpr float kEven = 1e-5f;  // of the squared scale: what rounding leaves of an even transform
  const glm::mat3 squares = glm::transpose(turn) * turn;
  const float scale2 = squares[0][0];
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(squares[c][r] - (c == r ? scale2 : 0.0f)) <= kEven * scale2)) return 0.0f;
  return scale2 > 0.0f ? 1.0f / std::sqrt(scale2) : 0.0f;
}

Object placed(const scene::Scene& scene, const scene::SceneSnapshot& snapshot, const scene::Instance& instance,
              const glm::dvec3& eye) {
  const glm::dmat4& m = instance.world_from_object;
  const scene::Primitive& primitive = scene.primitives[instance.primitive];
  Object object;
  object.primitive = &primitive;
  object.vertices = instance.deformed == scene::kNone ? &primitive.vertices
                                                      : &snapshot.deformed[static_cast<std::size_t>(instance.deformed)];
  object.turn = glm::mat3(glm::mat4(m));
  object.place = glm::vec3(glm::dvec3(m[3]) - eye);
  const glm::mat3 rows = glm::transpose(object.turn);
  object.cofactors = glm::transpose(
      glm::mat3(glm::cross(rows[1], rows[2]), glm::cross(rows[2], rows[0]), glm::cross(rows[0], rows[1])));
  object.handedness = glm::determinant(object.turn) < 0.0f ? -1.0f : 1.0f;
  object.inverse_scale = inverse_scale_of(object.turn);
  object.material = primitive.material == scene::kNone ? static_cast<std::uint32_t>(scene.materials.size())
                                                       : static_cast<std::uint32_t>(primitive.material);
  return object;
}

glm::vec3 unit_or_null(const glm::vec3& v) {
  const float squared = glm::dot(v, v);
  return squared > 0.0f ? v / std::sqrt(squared) : glm::vec3(0.0f);
}

float max_abs(const glm::vec3& v) {
  return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
}

template <class Vector>
Vector weighted(const SurfacePoint& p, const std::vector<Vector>& values) {
  return p.weights[0] * values[p.corners[0]] + p.weights[1] * values[p.corners[1]] +
         p.weights[2] * values[p.corners[2]];
}

}  // namespace

std::array<std::uint32_t, 3> Object::corners(std::uint32_t triangle) const {
  const std::uint32_t* first = primitive->indices.data() + 3 * std::size_t{triangle};
  return {first[0], first[1], first[2]};
}

std::array<glm::vec3, 3> Object::positions_ws(std::uint32_t triangle) const {
  const auto [a, b, c] = corners(triangle);
  return {position_ws(a), position_ws(b), position_ws(c)};
}

std::vector<Object> objects_of(const scene::Scene& scene, const scene::SceneSnapshot& snapshot, const glm::dvec3& eye) {
  std::vector<Object> objects;
  std::map<const scene::VertexFrames*, std::map<const scene::Primitive*, std::uint32_t>> meshes;
  std::uint32_t mesh_count = 0;
  for (const scene::Instance& instance : snapshot.instances) {
    if (scene.primitives[instance.primitive].topology != scene::Topology::triangles) continue;
    Object object = placed(scene, snapshot, instance, eye);
    const auto [found, added] = meshes[object.vertices].emplace(object.primitive, mesh_count);
    mesh_count += added ? 1 : 0;
    object.mesh = found->second;
    objects.push_back(object);
  }
  return objects;
}

SurfacePoint surface_point(const Object& object, std::uint32_t triangle, float u, float v) {
  SurfacePoint p;
  p.object = &object;
  p.corners = object.corners(triangle);
  p.weights = {1.0f - u - v, u, v};
  const auto [a, b, c] = object.positions_ws(triangle);
  p.position_ws = p.weights[0] * a + u * b + v * c;
  const glm::vec3 turned = object.handedness * glm::cross(b - a, c - a);
  const float twice_area = glm::length(turned);
  p.geometric_normal_ws = twice_area > 0.0f ? turned / twice_area : glm::vec3(0.0f, 1.0f, 0.0f);
  p.area_m2 = 0.5f * twice_area;
  p.rounding_m = kRounding * std::max(max_abs(a), std::max(max_abs(b), max_abs(c)));
  return p;
}

// Vertices' vectors are turned and normalised one by one, as the vertex shader does it. Even transforms keep unit
// vectors as long as each other, so that those can be added first.
glm::vec3 SurfacePoint::normal_ws() const {
  const auto& normals = object->vertices->normals;
  const float s = object->inverse_scale;
  if (s > 0.0f) return object->handedness * s * s * (object->cofactors * weighted(*this, normals));
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < 3; ++i) sum += weights[i] * unit_or_null(object->cofactors * normals[corners[i]]);
  return object->handedness * sum;
}

glm::vec4 SurfacePoint::tangent_ws() const {
  const auto& tangents = object->vertices->tangents;
  if (tangents.empty()) return glm::vec4(0.0f);
  if (object->inverse_scale > 0.0f) {
    const glm::vec4 sum = weighted(*this, tangents);
    return {object->inverse_scale * (object->turn * glm::vec3(sum)), sum.w * object->handedness};
  }
  glm::vec4 sum(0.0f);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec4& tangent = tangents[corners[i]];
    sum += weights[i] * glm::vec4(unit_or_null(object->turn * glm::vec3(tangent)), tangent.w * object->handedness);
  }
  return sum;
}

glm::vec4 SurfacePoint::color() const {
  return object->primitive->colors.empty() ? glm::vec4(1.0f) : weighted(*this, object->primitive->colors);
}

glm::vec2 SurfacePoint::uv(std::uint32_t set) const {
  const auto& uvs = object->primitive->uv[set];
  return uvs.empty() ? glm::vec2(0.0f) : weighted(*this, uvs);
}

float SurfacePoint::log2_uv(std::uint32_t set, float width_m) const {
  constexpr float kLeast = 1e-30f;  // triangles without area on either side read the largest mip
  const auto& uvs = object->primitive->uv[set];
  if (uvs.empty()) return 0.0f;
  const glm::vec2 e1 = uvs[corners[1]] - uvs[corners[0]], e2 = uvs[corners[2]] - uvs[corners[0]];
  const float area = 0.5f * std::abs(e1.x * e2.y - e1.y * e2.x);
  return 0.5f * std::log2(std::max(area * width_m * width_m / std::max(area_m2, kLeast), kLeast));
}

}  // namespace velarium::reference
