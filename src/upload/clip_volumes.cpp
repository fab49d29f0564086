#include "upload/clip_volumes.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace velarium::upload {
namespace {

// A plane that nothing is before.
constexpr glm::vec4 kNothing{0.0f, 0.0f, 0.0f, -1.0f};

// Normals go with the cofactors of a matrix, which are there also where it has no inverse, as where a node is scaled to
// nothing. They point to the wrong side where the matrix mirrors.
glm::dmat3 cofactors(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

glm::vec4 relative_plane(const glm::vec4& plane, const glm::dmat4& origin_from_object) {
  const glm::dmat3 linear(origin_from_object);
  const glm::dmat3 cofactor = cofactors(linear);
  const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 unit(plane);
  const glm::dvec3 normal = side * (cofactor * unit);
  const double length = glm::length(normal);
  if (!(length > 0.0)) return kNothing;
  const glm::dvec3 on_plane = origin_from_object * glm::dvec4(unit * -static_cast<double>(plane.w), 1.0);
  const glm::dvec3 direction = normal / length;
  return {glm::vec3(direction), static_cast<float>(-glm::dot(direction, on_plane))};
}

// Around the corners of the box that the volume lies in.
glm::vec4 relative_sphere(const scene::Aabb& bounds, const glm::dmat4& origin_from_object) {
  const glm::dvec3 middle =
      origin_from_object * glm::dvec4(0.5 * (glm::dvec3(bounds.min) + glm::dvec3(bounds.max)), 1.0);
  double radius = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 place((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                           (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                           (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
    radius = std::max(radius, glm::distance(middle, glm::dvec3(origin_from_object * glm::dvec4(place, 1.0))));
  }
  // Surfaces a little outside are asked as if they lay inside: see clip_point(). Twice as much leaves room for
  // rounding.
  const double clearance = 2.0 * static_cast<double>(shading::kClipClearance) * (glm::length(middle) + radius);
  return {glm::vec3(middle), static_cast<float>(radius + clearance)};
}

}  // namespace

ClipVolumeTable make_clip_volumes(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                                  const glm::dvec3& origin) {
  ClipVolumeTable table;
  const std::size_t count = scene.clip_volumes.size();
  table.records.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const scene::ClipVolume& volume = scene.clip_volumes[i];
    glm::dmat4 origin_from_object(snapshot.world_from_clip_volume[i]);
    origin_from_object[3] -= glm::dvec4(origin, 0.0);
    const auto first = static_cast<float>(table.records.size());
    for (const glm::vec4& plane : volume.planes) table.records.push_back(relative_plane(plane, origin_from_object));
    table.records[i] = {first, static_cast<float>(volume.planes.size()), 0.0f, 0.0f};
    table.spheres.push_back(relative_sphere(volume.bounds, origin_from_object));
  }
  return table;
}

bool any_clipped(const std::vector<GpuLight>& lights) {
  return std::ranges::any_of(lights, [](const GpuLight& light) { return light.clip_volume != 0; });
}

void limit_to_clip_volumes(const std::vector<GpuLight>& lights, const ClipVolumeTable& volumes,
                           const glm::mat4& view_from_world, std::vector<glm::vec4>& bounds) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (lights[i].clip_volume == 0) continue;
    const glm::vec4& sphere = volumes.spheres[lights[i].clip_volume - 1];
    if (sphere.w < bounds[i].w)
      bounds[i] = glm::vec4(glm::mat3(view_from_world) * glm::vec3(sphere) + glm::vec3(view_from_world[3]), sphere.w);
  }
}

}  // namespace velarium::upload
