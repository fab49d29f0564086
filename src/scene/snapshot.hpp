#pragma once

// The scene at one time: animations sampled, the node tree flattened, skins and morph targets applied.

#include "scene/scene.hpp"

#include <string>

namespace velarium::scene {

struct Instance {
  std::uint32_t primitive = 0;    // into Scene::primitives
  std::int32_t deformed = kNone;  // into SceneSnapshot::deformed where a skin or morph targets move this instance
  std::uint32_t node = 0;
  // Of skinned instances: a translation alone, as their vertices are turned as the world is.
  glm::dmat4 world_from_object{1.0};
  bool mirrored = false;  // negative determinant: front faces are clockwise
  WorldAabb bounds;
};

struct LightInstance {
  Light light;
  glm::dvec3 position{0.0};                // world space, metres
  glm::vec3 direction{0.0f, 0.0f, -1.0f};  // world space, unit, where the light shines to
  glm::vec3 right{1.0f, 0.0f, 0.0f};       // world space, unit, at right angles to it: +X of the node
};

struct AmbientLightInstance {
  AmbientLight light;
  glm::dmat4 world_from_node{1.0};
};

struct CameraInstance {
  Camera camera;                    // its name is the node's where the camera has none
  glm::dmat4 world_from_view{1.0};  // rigid: scale of the node tree removed
};

struct SceneSnapshot {
  std::vector<Instance> instances;  // in node order
  std::vector<VertexFrames> deformed;
  std::vector<LightInstance> lights;
  std::vector<AmbientLightInstance> ambient_lights;  // of nodes that are shown
  std::vector<CameraInstance> cameras;
  std::vector<glm::dmat4> world_from_clip_volume;  // by Scene::clip_volumes, whether their nodes are shown or not
  WorldAabb bounds;                                // of everything drawn: its vertices' own; empty where nothing is
};

// Of an instance's vertices, object space.
[[nodiscard]] const std::vector<glm::vec3>& positions_of(const Scene& scene, const SceneSnapshot& snapshot,
                                                         const Instance& instance);

// `animation`: a name, an index, "all", "none" (the pose of the nodes themselves), or empty for the first. Times
// outside a sampler clamp to its ends. Throws Error(usage) where no animation has that name, listing those there are.
[[nodiscard]] SceneSnapshot snapshot_at(const Scene& scene, float time_s, const std::string& animation);

// By node: does any animation move it, or one that it hangs on? Skins and morph targets are not asked:
// Instance::deformed.
[[nodiscard]] std::vector<bool> dynamic_nodes(const Scene& scene);

// A camera at `eye`. Throws Error(usage) where eye and target coincide or `up` is parallel to the view.
[[nodiscard]] CameraInstance look_at_camera(const glm::dvec3& eye, const glm::dvec3& target, const glm::vec3& up,
                                            float vertical_fov_rad);

// A three-quarter view from above, in which `bounds` just fits a picture of this aspect (width / height).
[[nodiscard]] CameraInstance fitted_camera(const WorldAabb& bounds, float aspect);

// The camera that `choice` names: a name or index of the scene's, "auto", or empty for the first, else auto.
// Throws Error(usage) where there is none of that name, listing those there are.
[[nodiscard]] CameraInstance choose_camera(const SceneSnapshot& snapshot, const std::string& choice, float aspect);

// Near plane where the camera names none that suits: see src/scene/cameras.cpp. Reversed-Z, [0,1] depth, +Y down
// in clip space as Vulkan has it; perspective cameras without z_far see without end.
[[nodiscard]] glm::mat4 clip_from_view(const Camera& camera, float aspect);

}  // namespace velarium::scene
