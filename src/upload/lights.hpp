#pragma once

#include "scene/moment.hpp"
#include "upload/gpu_structs.hpp"

#include <span>
#include <vector>

namespace velarium::upload {

// Where each kind begins in a table of lights.
struct LightRanges {
  std::uint32_t first_point = 0, first_spot = 0, count = 0;
  std::uint32_t sun = kNoSun;  // the brightest directional light that casts shadows
  bool sized = false;          // has any a radius or a disc?
  bool projectors = false;     // does any throw a picture?
};

// Lights as shaders read them, relative to the eye: directional ones, then points, then spots, each in the order of the
// scene. pictures: projector_pictures() of the scene.
[[nodiscard]] std::vector<GpuLight> gpu_lights(const std::vector<scene::LightInstance>& lights, const glm::dvec3& eye,
                                               std::span<const scene::Projector> pictures);

[[nodiscard]] LightRanges light_ranges(const std::vector<GpuLight>& lights);

// A sphere around everything that each light reaches, in view space: xyz centre, w radius.
[[nodiscard]] std::vector<glm::vec4> light_bounds(const std::vector<GpuLight>& lights,
                                                  const glm::mat3& view_from_world);

}  // namespace velarium::upload
