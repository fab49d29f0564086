// EXT_mesh_gpu_instancing: the copies of a node's mesh, as columns of translations, rotations and scales.

#include "scene/gltf_parts.hpp"
#include "scene/gltf_transforms.hpp"

#include <fmt/core.h>

#include <array>

namespace velarium::scene::gltf {

namespace {

constexpr std::array kVectorFormats = {Format{Type::vec3, Component::f32}};
constexpr std::array kRotationFormats = {Format{Type::vec4, Component::f32}, Format{Type::vec4, Component::i8, true},
                                         Format{Type::vec4, Component::i16, true}};

// What an instance takes, in elements of 16 bytes: its placement, and per primitive what snapshot_at() makes of it.
constexpr std::uint64_t kElementsAPlacement = 3, kElementsAnInstance = 8;

// Columns of one length, which the first that is there decides.
class Columns {
 public:
  Columns(Accessors& accessors, const Value& attributes) : accessors_(accessors), attributes_(attributes) {
    for (const auto& [name, reference] : attributes.members()) static_cast<void>(accessors.any(reference));
  }

  // Null where there is no such column.
  [[nodiscard]] const Accessor* find(std::string_view name, std::span<const Format> formats) {
    const Value reference = attributes_[name];
    if (!reference) return nullptr;
    const Accessor& accessor = accessors_.find(reference, formats, Integers::normalized);
    if (count_ == 0) count_ = accessor.elements.count;
    if (accessor.elements.count != count_) {
      reference.fail(fmt::format("has {} elements, but there are {} instances", accessor.elements.count, count_));
    }
    return &accessor;
  }
  [[nodiscard]] std::uint32_t count() const { return count_; }

 private:
  Accessors& accessors_;
  Value attributes_;
  std::uint32_t count_ = 0;
};

void read_placements(Accessors& accessors, const Value& extension, std::size_t primitives, Node& node) {
  const Value attributes = extension.require("attributes");
  Columns columns(accessors, attributes);
  const Accessor* translations = columns.find("TRANSLATION", kVectorFormats);
  const Accessor* rotations = columns.find("ROTATION", kRotationFormats);
  const Accessor* scales = columns.find("SCALE", kVectorFormats);
  if (columns.count() == 0) {
    attributes.warn("has no translations, rotations or scales; the mesh is drawn once");
    return;
  }
  accessors.claim(extension, columns.count() * (kElementsAPlacement + kElementsAnInstance * primitives));
  std::vector<Placement>& out = node.instances;
  out.resize(columns.count());
  if (translations) {
    const std::vector<glm::vec3> values = accessors.read_floats<glm::vec3>(*translations);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].translation = values[i];
  }
  if (rotations) {
    const std::vector<glm::vec4> values = accessors.read_floats<glm::vec4>(*rotations);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].rotation = unit_rotation(attributes["ROTATION"], values[i]);
  }
  if (scales) {
    const std::vector<glm::vec3> values = accessors.read_floats<glm::vec3>(*scales);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].scale = values[i];
  }
}

}  // namespace

void read_node_instances(Context& context, Accessors& accessors) {
  constexpr std::string_view kName = "EXT_mesh_gpu_instancing";
  const Value list = context.root["nodes"];
  for (std::uint32_t i = 0; i < list.size(); ++i) {
    const Value extension = list.at(i)["extensions"][kName];
    if (!extension) continue;
    if (!context.uses(kName)) extension.repair("is not listed in /extensionsUsed; it was read");
    Node& node = context.scene.nodes[i];
    if (node.mesh == kNone ||
        node.skin != kNone) {  // a skin places the vertices in the world, so copies would coincide
      extension.warn("belongs to a node without a mesh, or with a skin; it is ignored");
      continue;
    }
    const Mesh& mesh = context.scene.meshes[static_cast<std::size_t>(node.mesh)];
    read_placements(accessors, extension, mesh.primitives.size(), node);
  }
}

}  // namespace velarium::scene::gltf
