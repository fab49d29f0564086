#pragma once

// Shapes and a builder for the scenes of this folder. All shapes have unit normals, one uv set (u to the right, v down
// as seen from outside), counter-clockwise front faces and their bounds.

#include "scene/scene.hpp"

#include <array>
#include <functional>
#include <span>
#include <string>

namespace velarium::scene {

// Around the origin; poles on the Y axis. `rings` from pole to pole, `segments` around: at least 2 and 3.
[[nodiscard]] Primitive uv_sphere(float radius, std::uint32_t rings, std::uint32_t segments);

// Corners counter-clockwise as seen from the front.
[[nodiscard]] Primitive quad(const std::array<glm::vec3, 4>& corners);

// An upright block without a bottom: `base` counter-clockwise as seen from above, at one height.
[[nodiscard]] Primitive block(const std::array<glm::vec3, 4>& base, float height);

struct SurfacePoint {
  glm::vec3 position;
  glm::vec2 uv;
};

// A point of a smooth surface, s and t from 0 to 1; asked slightly outside too, for slopes. Its front is the side on
// which s x t points out. Triangles without area, as at poles, are left out.
using SurfaceFunction = std::function<SurfacePoint(float s, float t)>;
[[nodiscard]] Primitive surface(std::uint32_t columns, std::uint32_t rows, const SurfaceFunction& at);

// A profile is a polyline whose outside lies to its right: of a wall, upwards outside. Corners sharper than 40 degrees
// stay sharp. Texture coordinates of what is made of it are metres along the profile.
using Profile = std::vector<glm::vec2>;

// Turns (radius, height) about the Y axis. `around`: the texture's u once around, metres.
[[nodiscard]] Primitive lathe(const Profile& profile, std::uint32_t segments, float around);

// Leads (offset along +z, height) along x from -half_length to half_length, cut every `step` metres. `mitre`: metres
// that each end grows a metre of offset.
[[nodiscard]] Primitive straight_moulding(float half_length, const Profile& profile, float step, float mitre = 0.0f);

// Leads (offset outwards, height) around the rectangle |x| <= half.x, |z| <= half.y, mitred.
[[nodiscard]] Primitive rectangle_moulding(const glm::vec2& half, const Profile& profile, float step);

// A round bar through points, of one radius; open at its ends.
[[nodiscard]] Primitive tube(std::span<const glm::vec3> path, float radius, std::uint32_t segments);

// All six sides; texture coordinates in metres.
[[nodiscard]] Primitive box(const glm::vec3& low, const glm::vec3& high);

// Adds `part` as it looks under `transform`, which must not mirror. Scales may differ by axis.
void append(Primitive& whole, const Primitive& part, const glm::mat4& transform = glm::mat4(1.0f));

class SceneBuilder {
 public:
  explicit SceneBuilder(const std::string& name);

  // These return the number of what they add.
  std::uint32_t add_material(Material material);
  std::uint32_t add_mesh(const std::string& name, Primitive primitive, std::uint32_t material);
  std::int32_t add_texture(Image image, const Sampler& sampler = {});
  std::int32_t add_image(Image image);  // for what is no texture

  // Root nodes. Cameras and lights take the name of their node.
  void place_mesh(std::uint32_t mesh, const glm::vec3& position, float yaw_rad = 0.0f,
                  const glm::vec3& scale = glm::vec3(1.0f));
  void place_light(Light light, const glm::vec3& position, const glm::quat& rotation);
  // `aspect`: width / height of what the camera frames.
  void place_camera(float vertical_fov_rad, float aspect, const glm::vec3& eye, const glm::vec3& target,
                    const std::string& name = "camera");

  [[nodiscard]] Scene take() && { return std::move(scene_); }

 private:
  Node& add_node(const std::string& name, const glm::vec3& position);

  Scene scene_;
};

}  // namespace velarium::scene
