#pragma once

#include "scene/snapshot.hpp"
#include "upload/gpu_structs.hpp"

#include <span>
#include <vector>

namespace velarium::upload {

// Lights as shaders read them, relative to `origin`: directional ones, then points, then spots, each in the order of
// the scene. pictures: projector_pictures() of the scene.
[[nodiscard]] std::vector<GpuLight> gpu_lights(const std::vector<scene::LightInstance>& lights,
                                               const glm::dvec3& origin, std::span<const scene::Projector> pictures);

[[nodiscard]] LightRanges light_ranges(const std::vector<GpuLight>& lights);

// Has any a radius or a disc?
[[nodiscard]] bool any_area_light(const std::vector<GpuLight>& lights);
// Does any throw a picture?
[[nodiscard]] bool any_projector(const std::vector<GpuLight>& lights);

// A sphere around everything that each light reaches, in view space: xyz centre, w radius. view_from_world: rigid.
[[nodiscard]] std::vector<glm::vec4> light_bounds(const std::vector<GpuLight>& lights,
                                                  const glm::mat4& view_from_world);

}  // namespace velarium::upload
