#include "scene/description_parts.hpp"
#include "scene/description_place.hpp"
#include "scene/snapshot.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace velarium::scene::description {
namespace {

// A rotation may have been stored in 8 bits a component, as files have it; what is further off is a mistake.
constexpr float kLengthTolerance = 0.008f;
// Products and inverses of float matrices; their last row strays by rounding alone.
constexpr float kRowTolerance = 1e-4f;

glm::vec3 vector(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

glm::quat rotation_of(const Place& at, const std::array<float, 4>& xyzw) {
  at.finite("rotation", xyzw);
  const glm::vec4 q(xyzw[0], xyzw[1], xyzw[2], xyzw[3]);
  const float length = glm::length(q);
  if (!(std::abs(length - 1.0f) <= kLengthTolerance))
    at.fail("rotation", fmt::format("is a quaternion of length {}, must be 1", length));
  return unit_quaternion(q);
}

glm::mat4 matrix_of(const Place& at, const NodeDescription& node) {
  const NodeDescription untouched;
  at.finite("matrix", *node.matrix);
  if (node.translation != untouched.translation || node.rotation != untouched.rotation || node.scale != untouched.scale)
    at.fail("matrix", "stands beside translation, rotation or scale; give one of the two");
  glm::mat4 matrix;
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = (*node.matrix)[static_cast<std::size_t>(i)];
  for (int column = 0; column < 4; ++column) {
    float& last = matrix[column][3];
    const float wanted = column == 3 ? 1.0f : 0.0f;
    if (std::abs(last - wanted) > kRowTolerance) {
      at.fail("matrix",
              fmt::format("has {} as element {}, must be {}: the last row is 0 0 0 1", last, 4 * column + 3, wanted));
    }
    last = wanted;
  }
  return matrix;
}

Node node_of(const Place& at, const NodeDescription& from, const SceneDescription& description, std::size_t earlier) {
  Node node;
  node.name = from.name;
  if (from.parent && *from.parent >= earlier)
    at.fail("parent", fmt::format("is {}, must be an earlier node", *from.parent));
  node.parent = at.reference("parent", from.parent, earlier, "nodes");
  node.mesh = at.reference("mesh", from.mesh, description.meshes.size(), "meshes");
  at.finite("translation", from.translation);
  at.finite("scale", from.scale);
  node.translation = vector(from.translation);
  node.rotation = rotation_of(at, from.rotation);
  node.scale = vector(from.scale);
  if (from.matrix) node.matrix = glm::dmat4(matrix_of(at, from));
  return node;
}

void set_orthographic(const Place& at, const CameraDescription& from, Camera& camera) {
  at.not_negative("far_m", from.far_m);
  if (!(from.far_m > from.near_m)) at.fail("far_m", fmt::format("is {}, must be more than near_m", from.far_m));
  const float half_height = 0.5f * from.orthographic_height_m;
  camera.kind = Camera::Kind::orthographic;
  camera.half_size = {half_height * camera.aspect.value_or(1.0f), half_height};
  camera.z_near = from.near_m;
  camera.z_far = from.far_m;
}

CameraInstance looking(const Place& at, const LookAt& view) {
  at.finite("view.eye", view.eye);
  at.finite("view.target", view.target);
  at.finite("view.up", view.up);
  at.within("view.vertical_fov_deg", view.vertical_fov_deg, 0.0f, 180.0f);
  try {
    return look_at_camera(vector(view.eye), vector(view.target), vector(view.up), glm::radians(view.vertical_fov_deg));
  } catch (const Error& error) { at.fail("view", fmt::format("is no view: {}", error.what())); }
}

Node camera_node(const Place& at, const CameraDescription& from, const SceneDescription& description, Scene& scene) {
  const CameraInstance view = looking(at, from.view);
  at.not_negative("orthographic_height_m", from.orthographic_height_m);
  at.not_negative("aspect", from.aspect);
  at.not_negative("near_m", from.near_m);
  Camera camera = view.camera;
  camera.name = from.name;
  if (from.aspect > 0.0f) camera.aspect = from.aspect;
  if (from.near_m > 0.0f) camera.z_near = from.near_m;
  if (from.far_m > 0.0f) camera.z_far = from.far_m;
  if (!(camera.z_far > camera.z_near)) at.fail("far_m", fmt::format("is {}, must be more than near_m", from.far_m));
  if (from.orthographic_height_m > 0.0f) set_orthographic(at, from, camera);
  Node node;
  node.name = from.name;
  node.parent = at.reference("parent", from.parent, description.nodes.size(), "nodes");
  node.matrix = view.world_from_view;
  node.camera = static_cast<std::int32_t>(scene.cameras.size());
  scene.cameras.push_back(std::move(camera));
  return node;
}

}  // namespace

glm::quat unit_quaternion(const glm::vec4& xyzw) {
  const glm::vec4 unit = xyzw / glm::length(xyzw);
  return {unit.w, unit.x, unit.y, unit.z};
}

void add_node(Scene& scene, Node node) {
  const auto number = static_cast<std::uint32_t>(scene.nodes.size());
  auto& siblings = node.parent == kNone ? scene.roots : scene.nodes[static_cast<std::size_t>(node.parent)].children;
  siblings.push_back(number);
  scene.nodes.push_back(std::move(node));
}

void add_nodes(const SceneDescription& description, Scene& scene) {
  for (const NodeDescription& node : description.nodes) {
    const Place at("nodes", scene.nodes.size());
    add_node(scene, node_of(at, node, description, scene.nodes.size()));
  }
  if (!description.nodes.empty()) return;
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    Node node;
    node.name = scene.meshes[mesh].name;
    node.mesh = static_cast<std::int32_t>(mesh);
    add_node(scene, std::move(node));
  }
}

void add_cameras(const SceneDescription& description, Scene& scene) {
  for (const CameraDescription& camera : description.cameras) {
    const Place at("cameras", scene.cameras.size());
    add_node(scene, camera_node(at, camera, description, scene));
  }
}

}  // namespace velarium::scene::description
