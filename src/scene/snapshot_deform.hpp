#pragma once

#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace velarium::scene {

// How one instance of a primitive is bent. The pointers and spans are only read during the call.
struct Deformation {
  const Primitive* primitive = nullptr;
  std::vector<float> morph_weights;  // of the primitive's targets, in order; missing ones are 0
  // One a joint, less the translation of Deformation's instance; empty: no skin, the result stays in object space.
  std::span<const glm::mat4> world_from_bind;
};

// One set of vertices a deformation, computed on all cores. glTF 2.0, 3.7.2.2 (morph targets, applied first) and 3.7.3
// (skins). Normals stay perpendicular to the surface under non-uniform joint scale and keep facing out under mirroring.
[[nodiscard]] std::vector<VertexFrames> deformed_vertices(std::span<const Deformation> deformations);

}  // namespace velarium::scene
