#pragma once

// Animations sampled at a time, after glTF 2.0, appendix C.

#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace velarium::scene {

// The value at `time_s`, clamped to the ends, into `out` (of `sampler.components` floats).
// `is_rotation`: a quaternion x, y, z, w; linear means the shorter great arc, and the result is unit.
void sample(const AnimationSampler& sampler, float time_s, bool is_rotation, std::span<float> out);

// What an animation may change of a node.
struct Pose {
  glm::dvec3 translation{0.0};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
  std::vector<float> weights;  // of morph targets; empty where the node draws no mesh
};

// One pose a node. `animation` as for snapshot_at, with the same errors.
[[nodiscard]] std::vector<Pose> poses_at(const Scene& scene, float time_s, const std::string& animation);

}  // namespace velarium::scene
