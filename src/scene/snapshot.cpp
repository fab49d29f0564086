#include "scene/snapshot.hpp"

#include "core/assert.hpp"
#include "core/jobs.hpp"
#include "scene/animation.hpp"
#include "scene/snapshot_deform.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace velarium::scene {
namespace {

glm::dmat4 matrix_of(const glm::dvec3& translation, const glm::quat& rotation, const glm::vec3& scale) {
  glm::dmat4 matrix(glm::scale(glm::mat4_cast(rotation), scale));
  matrix[3] = glm::dvec4(translation, 1.0);
  return matrix;
}

glm::dmat4 parent_from_node(const Node& node, const Pose& pose) {
  if (node.matrix) return *node.matrix;
  return matrix_of(pose.translation, pose.rotation, pose.scale);
}

// Of every node, shown or not: a skin may follow joints outside the scene that is shown.
std::vector<glm::dmat4> world_matrices(const Scene& scene, const std::vector<Pose>& poses) {
  std::vector<glm::dmat4> world(scene.nodes.size(), glm::dmat4(1.0));
  std::vector<std::uint32_t> pending;
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].parent == kNone) pending.push_back(i);
  }
  while (!pending.empty()) {
    const std::uint32_t i = pending.back();
    pending.pop_back();
    const Node& node = scene.nodes[i];
    const glm::dmat4 local = parent_from_node(node, poses[i]);
    world[i] = node.parent == kNone ? local : world[static_cast<std::size_t>(node.parent)] * local;
    pending.insert(pending.end(), node.children.begin(), node.children.end());
  }
  return world;
}

std::vector<bool> shown_nodes(const Scene& scene) {
  std::vector<bool> shown(scene.nodes.size(), false);
  std::vector<std::uint32_t> pending(scene.roots);
  while (!pending.empty()) {
    const std::uint32_t i = pending.back();
    pending.pop_back();
    shown[i] = true;
    pending.insert(pending.end(), scene.nodes[i].children.begin(), scene.nodes[i].children.end());
  }
  return shown;
}

bool is_mirrored(const glm::dmat4& m) {
  return glm::determinant(glm::dmat3(m)) < 0.0;
}

// A direction of the node in world space; `fallback` where the node is scaled to nothing along it.
glm::vec3 world_axis(const glm::mat3& world_from_node, const glm::vec3& axis, const glm::vec3& fallback) {
  const glm::vec3 v = world_from_node * axis;
  const float length = glm::length(v);
  return length > 0.0f ? v / length : fallback;
}

// Keeps the place, where it looks and, as far as a right angle allows, which way is up. Directions are floats, as in
// every matrix of the device.
glm::dmat4 rigid(const glm::dmat4& m) {
  constexpr float kParallel = 1e-12f;  // squared sine of an angle that single precision cannot tell from zero
  const glm::mat3 turn(glm::mat4{m});
  const glm::vec3 back = world_axis(turn, {0, 0, 1}, {0, 0, 1});
  glm::vec3 right = glm::cross(world_axis(turn, {0, 1, 0}, {0, 1, 0}), back);
  if (glm::dot(right, right) < kParallel) {
    const glm::vec3 up = std::abs(back.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    right = glm::cross(up, back);
  }
  right = glm::normalize(right);
  return {glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0), m[3]};
}

// Whether what the matrix makes of a surface, a line or a point can be seen: it is not flattened to less than itself.
bool leaves_extent(const glm::dmat4& m, Topology topology) {
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  if (topology == Topology::points) return true;
  if (topology == Topology::lines) return x != glm::dvec3(0.0) || y != glm::dvec3(0.0) || z != glm::dvec3(0.0);
  const glm::dvec3 none(0.0);
  return glm::cross(x, y) != none || glm::cross(y, z) != none || glm::cross(z, x) != none;
}

class SnapshotBuilder {
 public:
  SnapshotBuilder(const Scene& scene, std::vector<Pose> poses)
      : scene_(scene), poses_(std::move(poses)), world_(world_matrices(scene, poses_)), joints_(scene.skins.size()) {}

  SceneSnapshot build() && {
    const std::vector<bool> shown = shown_nodes(scene_);
    for (std::uint32_t i = 0; i < scene_.nodes.size(); ++i) {
      if (!shown[i]) continue;
      const Node& node = scene_.nodes[i];
      if (node.mesh != kNone) add_mesh(i);
      if (node.light != kNone) add_light(node, world_[i]);
      if (node.camera != kNone) add_camera(node, world_[i]);
    }
    for (const ClipVolume& volume : scene_.clip_volumes)
      snapshot_.world_from_clip_volume.push_back(world_[volume.node]);
    for (const AmbientLight& light : scene_.ambient_lights)
      if (shown[light.node]) snapshot_.ambient_lights.push_back({light, world_[light.node]});
    snapshot_.deformed = deformed_vertices(deformations_);
    set_bounds();
    return std::move(snapshot_);
  }

 private:
  // Culling takes boxes about boxes; what the scene's camera is fitted to is as near as its vertices.
  void set_bounds() {
    std::vector<WorldAabb> seen(snapshot_.instances.size());
    parallel_for(snapshot_.instances.size(), [&](std::size_t i) {
      Instance& instance = snapshot_.instances[i];
      const Primitive& primitive = scene_.primitives[instance.primitive];
      instance.bounds = transformed(object_bounds(instance), instance.world_from_object);
      if (!leaves_extent(instance.world_from_object, primitive.topology)) return;
      const std::vector<glm::vec3>& positions = positions_of(scene_, snapshot_, instance);
      for (const std::uint32_t index : primitive.indices)
        seen[i].add(glm::dvec3(instance.world_from_object * glm::dvec4(positions[index], 1.0)));
    });
    for (const WorldAabb& box : seen) snapshot_.bounds.add(box);
  }

  void add_mesh(std::uint32_t node_index) {
    const Node& node = scene_.nodes[node_index];
    for (const std::uint32_t number : scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      const Primitive& primitive = scene_.primitives[number];
      Instance instance{number, kNone, node_index, world_[node_index], is_mirrored(world_[node_index]), {}};
      const bool skinned = node.skin != kNone && primitive.skin_sets > 0;
      if (skinned || !primitive.morph_targets.empty()) {
        instance.deformed = static_cast<std::int32_t>(deformations_.size());
        deformations_.push_back({&primitive, poses_[node_index].weights, {}});
      }
      if (skinned) {
        const Joints& joints = world_from_bind(static_cast<std::size_t>(node.skin));
        deformations_.back().world_from_bind = joints.place_from_bind;
        instance.world_from_object = glm::translate(glm::dmat4(1.0), joints.place);
        instance.mirrored = is_mirrored(glm::dmat4(joints.place_from_bind.front()));
      }
      add_instances(node, instance);
    }
  }

  // The copies share what deforms them.
  void add_instances(const Node& node, Instance instance) {
    if (node.instances.empty()) snapshot_.instances.push_back(instance);
    const glm::dmat4 world_from_node = instance.world_from_object;
    for (const Placement& placement : node.instances) {
      instance.world_from_object =
          world_from_node * matrix_of(placement.translation, placement.rotation, placement.scale);
      instance.mirrored = is_mirrored(instance.world_from_object);
      snapshot_.instances.push_back(instance);
    }
  }

  void add_light(const Node& node, const glm::dmat4& world) {
    const glm::dmat4 frame = rigid(world);
    LightInstance instance{scene_.lights[static_cast<std::size_t>(node.light)], glm::dvec3(world[3]),
                           -glm::vec3(frame[2]), glm::vec3(frame[0])};
    if (instance.light.name.empty()) instance.light.name = node.name;
    snapshot_.lights.push_back(std::move(instance));
  }

  void add_camera(const Node& node, const glm::dmat4& world) {
    CameraInstance instance{scene_.cameras[static_cast<std::size_t>(node.camera)], rigid(world)};
    if (instance.camera.name.empty()) instance.camera.name = node.name;
    snapshot_.cameras.push_back(std::move(instance));
  }

  // Where a skin stands, and its joints from there: floats hold these, however far it stands.
  struct Joints {
    glm::dvec3 place{0.0};
    std::vector<glm::mat4> place_from_bind;
  };

  // glTF 2.0, 3.7.3.1: the transform of the node that draws the mesh has no part in this.
  const Joints& world_from_bind(std::size_t skin_index) {
    const Skin& skin = scene_.skins[skin_index];
    Joints& out = joints_[skin_index];
    VEL_ASSERT(!skin.joints.empty());
    if (!out.place_from_bind.empty()) return out;
    out.place = glm::dvec3(world_[skin.joints.front()][3]);
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      glm::dmat4 world = world_[skin.joints[j]] * glm::dmat4(skin.joint_from_object[j]);
      world[3] -= glm::dvec4(out.place, 0.0);
      out.place_from_bind.emplace_back(world);
    }
    return out;
  }

  Aabb object_bounds(const Instance& instance) const {
    if (instance.deformed == kNone) return scene_.primitives[instance.primitive].bounds;
    Aabb bounds;
    const std::vector<glm::vec3>& positions = positions_of(scene_, snapshot_, instance);
    for (const std::uint32_t i : scene_.primitives[instance.primitive].indices) bounds.add(positions[i]);
    return bounds;
  }

  const Scene& scene_;
  std::vector<Pose> poses_;
  std::vector<glm::dmat4> world_;  // a node
  std::vector<Joints> joints_;     // a skin, made when first asked for
  std::vector<Deformation> deformations_;
  SceneSnapshot snapshot_;
};

}  // namespace

std::vector<bool> dynamic_nodes(const Scene& scene) {
  std::vector<bool> moving(scene.nodes.size(), false);
  std::vector<std::uint32_t> pending;
  for (const auto& animation : scene.animations)
    for (const auto& channel : animation.channels) pending.push_back(channel.node);
  while (!pending.empty()) {
    const std::uint32_t i = pending.back();
    pending.pop_back();
    if (moving[i]) continue;
    moving[i] = true;
    pending.insert(pending.end(), scene.nodes[i].children.begin(), scene.nodes[i].children.end());
  }
  return moving;
}

const std::vector<glm::vec3>& positions_of(const Scene& scene, const SceneSnapshot& snapshot,
                                           const Instance& instance) {
  return instance.deformed == kNone ? scene.primitives[instance.primitive].vertices.positions
                                    : snapshot.deformed[static_cast<std::size_t>(instance.deformed)].positions;
}

SceneSnapshot snapshot_at(const Scene& scene, float time_s, const std::string& animation) {
  return SnapshotBuilder(scene, poses_at(scene, time_s, animation)).build();
}

}  // namespace velarium::scene
