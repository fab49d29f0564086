#pragma once

// Shapes and a builder for the scenes of this folder. All shapes have unit normals, one uv set (u to the right, v down
// as seen from outside), counter-clockwise front faces and their bounds.

#include "scene/scene.hpp"

#include <array>
#include <string>

namespace velarium::scene {

// Around the origin; poles on the Y axis. `rings` from pole to pole, `segments` around: at least 2 and 3.
[[nodiscard]] Primitive uv_sphere(float radius, std::uint32_t rings, std::uint32_t segments);

// Corners counter-clockwise as seen from the front.
[[nodiscard]] Primitive quad(const std::array<glm::vec3, 4>& corners);

// An upright block without a bottom: `base` counter-clockwise as seen from above, at one height.
[[nodiscard]] Primitive block(const std::array<glm::vec3, 4>& base, float height);

class SceneBuilder {
 public:
  explicit SceneBuilder(const std::string& name);

  // These return the number of what they add.
  std::uint32_t add_material(Material material);
  std::uint32_t add_mesh(const std::string& name, Primitive primitive, std::uint32_t material);

  // Root nodes. Cameras and lights take the name of their node.
  void place_mesh(std::uint32_t mesh, const glm::vec3& position);
  void place_light(Light light, const glm::vec3& position, const glm::quat& rotation);
  // `aspect`: width / height of what the camera frames.
  void place_camera(float vertical_fov_rad, float aspect, const glm::vec3& eye, const glm::vec3& target);

  [[nodiscard]] Scene take() && { return std::move(scene_); }

 private:
  Node& add_node(const std::string& name, const glm::vec3& position);

  Scene scene_;
};

}  // namespace velarium::scene
