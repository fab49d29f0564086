#include "passes/ambient_lights/ambient_lights.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <optional>

namespace velarium::ambient_lights {
namespace {

constexpr double kThinnest = 1e-6;  // metres

// The unit sphere becomes the volume.
glm::dmat3 extents_of(const scene::AmbientLightInstance& instance) {
  return glm::dmat3(instance.world_from_node) * static_cast<double>(instance.light.range);
}

scene::WorldAabb bounds_of(const glm::dmat3& extents, const glm::dvec3& center) {
  const glm::dmat3 rows = glm::transpose(extents);
  const glm::dvec3 half(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  scene::WorldAabb bounds;
  bounds.add(center - half);
  bounds.add(center + half);
  return bounds;
}

// None for a volume thinner than a micrometre, as where its node is scaled to nothing along some axis: it holds no
// points.
std::optional<glm::dmat3> unit_from_extents(const glm::dmat3& extents) {
  const glm::dmat3 inverse = glm::inverse(extents);
  for (int column = 0; column < 3; ++column)
    if (!(glm::length(inverse[column]) < 1.0 / kThinnest)) return std::nullopt;
  return inverse;
}

shading::GpuAmbientLight gpu_light(const glm::dmat3& unit_from_world, const glm::dvec3& center,
                                   const glm::vec3& color) {
  const glm::dmat3 rows = glm::transpose(unit_from_world);
  return {.x = glm::vec4(glm::dvec4(rows[0], center.x)),
          .y = glm::vec4(glm::dvec4(rows[1], center.y)),
          .z = glm::vec4(glm::dvec4(rows[2], center.z)),
          .color = glm::vec4(color, 0.0f)};
}

}  // namespace

std::vector<shading::GpuAmbientLight> lights_in_view(const upload::Tables& tables, const upload::ViewMatrices& view) {
  const upload::Frustum frustum = upload::frustum_of(view);
  std::vector<shading::GpuAmbientLight> lights;
  for (const auto& instance : tables.snapshot->ambient_lights) {
    const glm::dvec3 center(instance.world_from_node[3]);
    const glm::dmat3 extents = extents_of(instance);
    if (!upload::overlaps(frustum, bounds_of(extents, center))) continue;
    if (const auto unit_from_world = unit_from_extents(extents))
      lights.push_back(gpu_light(*unit_from_world, center - tables.origin, instance.light.color));
  }
  return lights;
}

Reading add(graph::Graph& graph, const upload::Tables& tables, const upload::ViewMatrices& view,
            const Settings& settings) {
  if (!settings.enabled) return {};
  const auto lights = lights_in_view(tables, view);
  if (lights.empty()) return {};
  const io::AmbientLights table{.count = static_cast<std::uint32_t>(lights.size())};
  return {.count = table.count,
          .lights = graph.upload("ambient_lights.lights", lights),
          .table = graph.upload("ambient_lights.table", table)};
}

}  // namespace velarium::ambient_lights
