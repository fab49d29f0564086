#include "core/jobs.hpp"
#include "scene/gltf_attributes.hpp"
#include "scene/gltf_draco.hpp"
#include "scene/gltf_parts.hpp"
#include "scene/gltf_topology.hpp"
#include "scene/tangents.hpp"

#include <fmt/core.h>

#include <array>
#include <limits>
#include <numeric>
#include <optional>

namespace velarium::scene::gltf {

namespace {

constexpr std::array kIndexFormats = {Format{Type::scalar, Component::u8}, Format{Type::scalar, Component::u16},
                                      Format{Type::scalar, Component::u32}};

std::uint32_t restart_value(Component component) {
  if (component == Component::u8) return std::numeric_limits<std::uint8_t>::max();
  if (component == Component::u16) return std::numeric_limits<std::uint16_t>::max();
  return std::numeric_limits<std::uint32_t>::max();
}

std::vector<std::uint32_t> read_indices(Accessors& accessors, const Value& reference, std::size_t vertex_count) {
  const Accessor& accessor = accessors.find(reference, kIndexFormats);
  std::vector<std::uint32_t> indices = accessors.read_indices(accessor);
  // glTF has no primitive restart, so that the largest index is refused even where a vertex has it (3.7.2.1).
  const std::uint32_t restart = restart_value(accessor.format.component);
  const std::size_t allowed = std::min<std::size_t>(vertex_count, restart);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < allowed) continue;
    if (indices[i] == restart) reference.fail(fmt::format("index number {} is the primitive restart value", i));
    reference.fail(fmt::format("index number {} is {}, but there are {} vertices", i, indices[i], vertex_count));
  }
  return indices;
}

std::vector<std::uint32_t> every_vertex(Accessors& accessors, const Value& place, std::size_t vertex_count) {
  accessors.claim(place, vertex_count);
  std::vector<std::uint32_t> indices(vertex_count);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

// Gives every texture of the material coordinates to read, so that what follows need not ask.
void supply_missing_uv(const Context& context, Accessors& accessors, const Value& value, Primitive& primitive) {
  if (primitive.material == kNone) return;
  for (const TextureRef* ref : texture_refs(context.scene.materials[static_cast<std::size_t>(primitive.material)])) {
    std::vector<glm::vec2>& uv = primitive.uv[ref->uv_set];
    if (!ref->present() || !uv.empty()) continue;
    accessors.claim(value, primitive.vertex_count());
    uv.resize(primitive.vertex_count());
    value.repair(fmt::format("has no TEXCOORD_{}, which its material asks for; 0 is used", ref->uv_set));
  }
}

// None where the primitive draws nothing.
std::optional<Primitive> read_primitive(Context& context, Accessors& accessors, const Value& value) {
  Primitive primitive;
  const DracoGeometry compressed(context, accessors, value);
  const auto mode = compressed ? Mode::triangles : static_cast<Mode>(value["mode"].integer_or(4, 0, 6));
  const auto material_count = static_cast<std::uint32_t>(context.scene.materials.size());
  primitive.topology = topology_of(mode);
  primitive.material = value["material"].reference_or_none(material_count, "materials");
  if (!value.require("attributes")["POSITION"]) {
    value.warn("has no positions; it is left out");
    return std::nullopt;
  }
  read_extensions(context, value, &Extension::primitive, primitive);
  read_attributes(context, accessors, value, primitive);
  read_morph_targets(context, accessors, value, primitive);
  supply_missing_uv(context, accessors, value, primitive);

  const Value indices = value["indices"];
  std::vector<std::uint32_t> listed = indices ? read_indices(accessors, indices, primitive.vertex_count())
                                              : every_vertex(accessors, value, primitive.vertex_count());
  if (left_over(mode, listed.size()) > 0) {
    value.repair("its last vertices make no whole line or triangle; they are ignored");
  }
  primitive.indices = as_list(mode, std::move(listed));
  if (primitive.indices.empty()) return std::nullopt;
  return primitive;
}

void check_morph_counts(const Value& mesh, const std::vector<Value>& primitives) {
  const std::uint32_t count = primitives.front()["targets"].size();
  for (const Value& primitive : primitives) {
    const Value targets = primitive["targets"];
    if (targets.size() != count) {
      (targets ? targets : primitive)
          .fail(fmt::format("has {} morph targets, but the mesh's first primitive has {}", targets.size(), count));
    }
  }
  const Value weights = mesh["weights"];
  if (weights && weights.size() != count) {
    weights.fail(fmt::format("has {} weights, but the mesh has {} morph targets", weights.size(), count));
  }
}

Mesh read_mesh(Context& context, Accessors& accessors, const Value& value) {
  Mesh mesh;
  mesh.name = value["name"].text_or("");
  const Value list = value.require("primitives");
  const std::vector<Value> primitives = list.elements();
  if (primitives.empty()) list.fail("is empty; a mesh has at least one primitive");
  check_morph_counts(value, primitives);
  for (const Value& weight : value["weights"].elements()) mesh.weights.push_back(weight.number());
  for (const Value& entry : primitives) {
    std::optional<Primitive> primitive = read_primitive(context, accessors, entry);
    if (!primitive) continue;
    mesh.primitives.push_back(static_cast<std::uint32_t>(context.scene.primitives.size()));
    context.scene.primitives.push_back(std::move(*primitive));
  }
  return mesh;
}

void complete_primitive(const Scene& scene, Primitive& primitive) {
  for (const std::uint32_t i : primitive.indices) primitive.bounds.add(primitive.vertices.positions[i]);
  fill_zero_normals(primitive);
  if (primitive.topology != Topology::triangles) return;
  if (primitive.vertices.normals.empty()) make_flat_normals(primitive);
  if (primitive.material == kNone || !primitive.vertices.tangents.empty()) return;
  const Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
  if (material.normal_texture.present() && !material.unlit) make_tangents(primitive, material.normal_texture.uv_set);
}

}  // namespace

void read_meshes(Context& context, Accessors& accessors) {
  for (const Value& value : context.root["meshes"].elements()) {
    context.scene.meshes.push_back(read_mesh(context, accessors, value));
  }
}

std::uint32_t morph_target_count(const Context& context, std::uint32_t mesh) {
  return context.root["meshes"].at(mesh)["primitives"].at(0)["targets"].size();
}

void complete_primitives(Scene& scene) {
  parallel_for(scene.primitives.size(), [&](std::size_t i) { complete_primitive(scene, scene.primitives[i]); });
}

}  // namespace velarium::scene::gltf
