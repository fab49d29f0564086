#pragma once

#include "scene/moment.hpp"
#include "upload/gpu_structs.hpp"

#include <vector>

namespace velarium::upload {

// Lights as shaders read them, relative to the eye, in the order of the scene.
[[nodiscard]] std::vector<GpuLight> gpu_lights(const std::vector<scene::LightInstance>& lights, const glm::dvec3& eye);

// A sphere around everything that each light reaches, in view space: xyz centre, w radius.
[[nodiscard]] std::vector<glm::vec4> light_bounds(const std::vector<GpuLight>& lights,
                                                  const glm::mat3& view_from_world);

}  // namespace velarium::upload
