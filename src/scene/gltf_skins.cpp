#include "scene/gltf_parts.hpp"
#include "scene/gltf_transforms.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

namespace velarium::scene::gltf {

namespace {

constexpr std::array kMatrixFormats = {Format{Type::mat4, Component::f32}};

Skin read_skin(const Context& context, Accessors& accessors, const Value& value) {
  Skin skin;
  skin.name = value["name"].text_or("");
  const auto node_count = static_cast<std::uint32_t>(context.scene.nodes.size());
  static_cast<void>(value["skeleton"].reference_or_none(node_count, "nodes"));  // a hint that nothing here needs
  const Value joints = value.require("joints");
  for (const Value& joint : joints.elements()) skin.joints.push_back(joint.reference(node_count, "nodes"));
  if (skin.joints.empty()) joints.fail("is empty; a skin has at least one joint");
  accessors.claim(joints, skin.joints.size());
  const Value matrices = value["inverseBindMatrices"];
  if (!matrices) {
    skin.joint_from_object.assign(skin.joints.size(), glm::mat4(1.0f));
    return skin;
  }
  skin.joint_from_object = accessors.read_floats<glm::mat4>(accessors.find(matrices, kMatrixFormats));
  if (skin.joint_from_object.size() < skin.joints.size()) {
    matrices.fail(
        fmt::format("has {} matrices, fewer than the {} joints", skin.joint_from_object.size(), skin.joints.size()));
  }
  skin.joint_from_object.resize(skin.joints.size());
  for (glm::mat4& matrix : skin.joint_from_object) check_affine(matrices, matrix);
  return skin;
}

// What a skin must know of the mesh that it moves.
struct MeshSkinning {
  std::size_t skinned = 0, rigid = 0;  // primitives
  std::uint32_t largest_joint = 0;
};

MeshSkinning skinning_of(const Scene& scene, const Mesh& mesh) {
  MeshSkinning result;
  for (const std::uint32_t index : mesh.primitives) {
    const Primitive& primitive = scene.primitives[index];
    ++(primitive.skin_sets > 0 ? result.skinned : result.rigid);
    for (const glm::u16vec4& joints : primitive.joints) {
      for (int c = 0; c < 4; ++c) result.largest_joint = std::max<std::uint32_t>(result.largest_joint, joints[c]);
    }
  }
  return result;
}

void check_skinned_node(const Scene& scene, const Value& value, const MeshSkinning& mesh, Node& node) {
  const Value skin = value["skin"];
  if (mesh.skinned == 0) {
    skin.repair("belongs to a mesh without joints; it is ignored");
    node.skin = kNone;
    return;
  }
  if (mesh.rigid > 0) skin.fail("belongs to a mesh of which some primitives have joints and others do not");
  const std::size_t joint_count = scene.skins[static_cast<std::size_t>(node.skin)].joints.size();
  if (mesh.largest_joint >= joint_count) {
    skin.fail(
        fmt::format("has {} joints, but /meshes/{} asks for joint {}", joint_count, node.mesh, mesh.largest_joint));
  }
}

}  // namespace

void read_skins(Context& context, Accessors& accessors) {
  for (const Value& value : context.root["skins"].elements()) {
    context.scene.skins.push_back(read_skin(context, accessors, value));
  }
}

void check_instances(Context& context) {
  Scene& scene = context.scene;
  std::vector<MeshSkinning> skinning;
  for (const Mesh& mesh : scene.meshes) skinning.push_back(skinning_of(scene, mesh));
  const Value nodes = context.root["nodes"];
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    Node& node = scene.nodes[i];
    if (node.skin != kNone) check_skinned_node(scene, nodes.at(i), skinning[static_cast<std::size_t>(node.mesh)], node);
  }
}

}  // namespace velarium::scene::gltf
