#pragma once

// Volumes that lights end at, as shaders and the path tracer read them.

#include "scene/snapshot.hpp"
#include "upload/gpu_structs.hpp"

#include <vector>

namespace velarium::upload {

struct ClipVolumeTable {
  // One record a volume of the scene, in its order: the index of its first plane in this table and how many follow;
  // then the planes. World axes, relative to the origin: see shading/clip_volume.glsl.
  std::vector<glm::vec4> records;
  std::vector<glm::vec4> spheres;  // around each volume: xyz centre, w radius
};

[[nodiscard]] ClipVolumeTable make_clip_volumes(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                                                const glm::dvec3& origin);

[[nodiscard]] bool any_clipped(const std::vector<GpuLight>& lights);

// Makes the bounds of lights that end at a volume no larger than its sphere, so that tiles outside refuse them.
// bounds: as light_bounds() gave them for the same lights and view.
void limit_to_clip_volumes(const std::vector<GpuLight>& lights, const ClipVolumeTable& volumes,
                           const glm::mat4& view_from_world, std::vector<glm::vec4>& bounds);

}  // namespace velarium::upload
