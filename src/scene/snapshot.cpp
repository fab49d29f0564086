#include "scene/snapshot.hpp"

#include "core/assert.hpp"
#include "scene/animation.hpp"
#include "scene/snapshot_deform.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace velarium::scene {
namespace {

glm::mat4 matrix_of(const glm::vec3& translation, const glm::quat& rotation, const glm::vec3& scale) {
  return glm::scale(glm::translate(glm::mat4(1.0f), translation) * glm::mat4_cast(rotation), scale);
}

glm::mat4 parent_from_node(const Node& node, const Pose& pose) {
  if (node.matrix) return *node.matrix;
  return matrix_of(pose.translation, pose.rotation, pose.scale);
}

// Of every node, shown or not: a skin may follow joints outside the scene that is shown.
std::vector<glm::mat4> world_matrices(const Scene& scene, const std::vector<Pose>& poses) {
  std::vector<glm::mat4> world(scene.nodes.size(), glm::mat4(1.0f));
  std::vector<std::uint32_t> pending;
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].parent == kNone) pending.push_back(i);
  }
  while (!pending.empty()) {
    const std::uint32_t i = pending.back();
    pending.pop_back();
    const Node& node = scene.nodes[i];
    const glm::mat4 local = parent_from_node(node, poses[i]);
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

bool is_mirrored(const glm::mat4& m) {
  return glm::determinant(glm::mat3(m)) < 0.0f;
}

// A direction of the node in world space; `fallback` where the node is scaled to nothing along it.
glm::vec3 world_axis(const glm::mat4& world_from_node, const glm::vec3& axis, const glm::vec3& fallback) {
  const glm::vec3 v = glm::mat3(world_from_node) * axis;
  const float length = glm::length(v);
  return length > 0.0f ? v / length : fallback;
}

// Keeps the place, where it looks and, as far as a right angle allows, which way is up.
glm::mat4 rigid(const glm::mat4& m) {
  constexpr float kParallel = 1e-12f;  // squared sine of an angle that single precision cannot tell from zero
  const glm::vec3 back = world_axis(m, {0, 0, 1}, {0, 0, 1});
  glm::vec3 right = glm::cross(world_axis(m, {0, 1, 0}, {0, 1, 0}), back);
  if (glm::dot(right, right) < kParallel) {
    const glm::vec3 up = std::abs(back.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    right = glm::cross(up, back);
  }
  right = glm::normalize(right);
  return {glm::vec4(right, 0), glm::vec4(glm::cross(back, right), 0), glm::vec4(back, 0), m[3]};
}

class MomentBuilder {
 public:
  MomentBuilder(const Scene& scene, std::vector<Pose> poses)
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
    for (Instance& instance : snapshot_.instances) {
      instance.bounds = object_bounds(instance).transformed(instance.world_from_object);
      snapshot_.bounds.add(instance.bounds);
    }
    return std::move(snapshot_);
  }

 private:
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
        const std::vector<glm::mat4>& joints = world_from_bind(static_cast<std::size_t>(node.skin));
        deformations_.back().world_from_bind = joints;
        instance.world_from_object = glm::mat4(1.0f);
        instance.mirrored = is_mirrored(joints.front());
      }
      add_instances(node, instance);
    }
  }

  // The copies share what deforms them.
  void add_instances(const Node& node, Instance instance) {
    if (node.instances.empty()) snapshot_.instances.push_back(instance);
    const glm::mat4 world_from_node = instance.world_from_object;
    for (const Placement& placement : node.instances) {
      instance.world_from_object =
          world_from_node * matrix_of(placement.translation, placement.rotation, placement.scale);
      instance.mirrored = is_mirrored(instance.world_from_object);
      snapshot_.instances.push_back(instance);
    }
  }

  void add_light(const Node& node, const glm::mat4& world) {
    const glm::mat4 frame = rigid(world);
    LightInstance instance{scene_.lights[static_cast<std::size_t>(node.light)], glm::vec3(world[3]),
                           -glm::vec3(frame[2]), glm::vec3(frame[0])};
    if (instance.light.name.empty()) instance.light.name = node.name;
    snapshot_.lights.push_back(std::move(instance));
  }

  void add_camera(const Node& node, const glm::mat4& world) {
    CameraInstance instance{scene_.cameras[static_cast<std::size_t>(node.camera)], rigid(world)};
    if (instance.camera.name.empty()) instance.camera.name = node.name;
    snapshot_.cameras.push_back(std::move(instance));
  }

  // glTF 2.0, 3.7.3.1: the transform of the node that draws the mesh has no part in this.
  const std::vector<glm::mat4>& world_from_bind(std::size_t skin_index) {
    const Skin& skin = scene_.skins[skin_index];
    std::vector<glm::mat4>& out = joints_[skin_index];
    if (out.empty()) {
      for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        out.push_back(world_[skin.joints[j]] * skin.joint_from_object[j]);
      }
    }
    VEL_ASSERT(!out.empty());
    return out;
  }

  Aabb object_bounds(const Instance& instance) const {
    if (instance.deformed == kNone) return scene_.primitives[instance.primitive].bounds;
    Aabb bounds;
    for (const glm::vec3& p : snapshot_.deformed[static_cast<std::size_t>(instance.deformed)].positions) bounds.add(p);
    return bounds;
  }

  const Scene& scene_;
  std::vector<Pose> poses_;
  std::vector<glm::mat4> world_;                // a node
  std::vector<std::vector<glm::mat4>> joints_;  // a skin: world from bind pose, made when first asked for
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
  return MomentBuilder(scene, poses_at(scene, time_s, animation)).build();
}

}  // namespace velarium::scene
