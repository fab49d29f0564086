#include "support/gltf_writer.hpp"
#include "support/temporary_folder.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace velarium::test {
namespace {

using Json = nlohmann::json;

constexpr int kUnsignedInt = 5125, kFloat = 5126;  // componentType of glTF 2.0, 3.6.2.2

Json json(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

template <class Vector>
std::vector<float> components_of(const std::vector<Vector>& vectors) {
  std::vector<float> components;
  for (const Vector& v : vectors)
    for (int c = 0; c < Vector::length(); ++c) components.push_back(v[c]);
  return components;
}

std::string image_name(std::size_t index) {
  return "image" + std::to_string(index) + ".png";
}

// The rotation that turns -Z, along which cameras look and lights shine, to `direction`.
Json turned_to(const glm::vec3& direction) {
  const glm::vec3 unit = glm::normalize(direction);
  const glm::vec3 up = std::abs(unit.y) > 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::quat q = glm::quatLookAt(unit, up);
  return {q.x, q.y, q.z, q.w};
}

void use_extension(Json& root, const char* name) {
  Json& used = root["extensionsUsed"];
  for (const auto& known : used)
    if (known == name) return;
  used.push_back(name);
}

}  // namespace

GltfWriter::GltfWriter(const glm::dvec3& origin) {
  root_["asset"] = {{"version", "2.0"}};
  root_["scene"] = 0;
  root_["scenes"] = Json::array({{{"nodes", {0}}}});
  root_["nodes"] = Json::array({{{"translation", {origin.x, origin.y, origin.z}}}});
}

int GltfWriter::add_child(Json node) {
  Json& nodes = root_["nodes"];
  const int index = static_cast<int>(nodes.size());
  nodes.push_back(std::move(node));
  nodes[0]["children"].push_back(index);
  return index;
}

int GltfWriter::add_image(image::ByteImage image) {
  const std::size_t index = images_.size();
  images_.push_back(std::move(image));
  root_["images"].push_back({{"uri", image_name(index)}});
  root_["textures"].push_back({{"source", index}});
  return static_cast<int>(index);
}

int GltfWriter::add_material(const TestMaterial& m) {
  Json material{{"pbrMetallicRoughness",
                 {{"baseColorFactor", {m.base_color.x, m.base_color.y, m.base_color.z, m.base_color.w}},
                  {"metallicFactor", m.metallic},
                  {"roughnessFactor", m.perceptual_roughness}}},
                {"emissiveFactor", json(m.emissive)},
                {"alphaMode", m.alpha_mode},
                {"doubleSided", m.double_sided}};
  if (m.base_color_image >= 0) material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", m.base_color_image}};
  if (m.normal_image >= 0) material["normalTexture"] = {{"index", m.normal_image}};
  const auto extend = [&](const char* name, Json value) {
    material["extensions"][name] = std::move(value);
    use_extension(root_, name);
  };
  extend("KHR_materials_specular", {{"specularFactor", m.specular}});
  if (m.emissive_strength != 1.0f)
    extend("KHR_materials_emissive_strength", {{"emissiveStrength", m.emissive_strength}});
  if (m.unlit) extend("KHR_materials_unlit", Json::object());
  root_["materials"].push_back(std::move(material));
  return static_cast<int>(root_["materials"].size()) - 1;
}

int GltfWriter::add_view(const void* bytes, std::size_t size) {
  root_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}});
  bytes_.append(static_cast<const char*>(bytes), size);
  return static_cast<int>(root_["bufferViews"].size()) - 1;
}

int GltfWriter::add_indices(const std::vector<std::uint32_t>& indices) {
  root_["accessors"].push_back({{"bufferView", add_view(indices.data(), indices.size() * sizeof(std::uint32_t))},
                                {"componentType", kUnsignedInt},
                                {"count", indices.size()},
                                {"type", "SCALAR"}});
  return static_cast<int>(root_["accessors"].size()) - 1;
}

int GltfWriter::add_accessor(const std::vector<float>& values, int components, bool bounds) {
  const std::size_t count = values.size() / static_cast<std::size_t>(components);
  Json accessor{{"bufferView", add_view(values.data(), values.size() * sizeof(float))},
                {"componentType", kFloat},
                {"count", count},
                {"type", "VEC" + std::to_string(components)}};
  if (bounds) {
    Json lowest, highest;
    for (int c = 0; c < components; ++c) {
      float low = values[static_cast<std::size_t>(c)], high = low;
      for (std::size_t i = static_cast<std::size_t>(c); i < values.size(); i += static_cast<std::size_t>(components)) {
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
      }
      lowest.push_back(low);
      highest.push_back(high);
    }
    accessor["min"] = lowest;
    accessor["max"] = highest;
  }
  root_["accessors"].push_back(std::move(accessor));
  return static_cast<int>(root_["accessors"].size()) - 1;
}

void GltfWriter::add_mesh(int material, const TestMesh& mesh, const TestPlace& place) {
  Json attributes{{"POSITION", add_accessor(components_of(mesh.positions), 3, true)}};
  if (!mesh.normals.empty()) attributes["NORMAL"] = add_accessor(components_of(mesh.normals), 3, false);
  if (!mesh.uv.empty()) attributes["TEXCOORD_0"] = add_accessor(components_of(mesh.uv), 2, false);
  Json primitive{{"attributes", std::move(attributes)}, {"material", material}};
  if (!mesh.indices.empty()) primitive["indices"] = add_indices(mesh.indices);
  root_["meshes"].push_back({{"primitives", Json::array({std::move(primitive)})}});
  const glm::quat& q = place.rotation;
  add_child({{"mesh", root_["meshes"].size() - 1},
             {"translation", json(place.translation)},
             {"rotation", {q.x, q.y, q.z, q.w}},
             {"scale", json(place.scale)}});
}

void GltfWriter::add_quad(int material, const glm::vec3& center, const glm::vec3& normal, const glm::vec2& size) {
  const glm::vec3 n = glm::normalize(normal);
  const glm::vec3 side = std::abs(n.y) > 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 x = 0.5f * size.x * glm::normalize(glm::cross(side, n));
  const glm::vec3 y = 0.5f * size.y * glm::normalize(glm::cross(n, x));
  std::vector<float> positions, normals;
  for (const glm::vec3& p :
       {center - x - y, center + x - y, center + x + y, center - x - y, center + x + y, center - x + y}) {
    positions.insert(positions.end(), {p.x, p.y, p.z});
    normals.insert(normals.end(), {n.x, n.y, n.z});
  }
  const int position = add_accessor(positions, 3, true), direction = add_accessor(normals, 3, false);
  const Json primitive{{"attributes", {{"POSITION", position}, {"NORMAL", direction}}}, {"material", material}};
  root_["meshes"].push_back({{"primitives", Json::array({primitive})}});
  add_child({{"mesh", root_["meshes"].size() - 1}});
}

void GltfWriter::add_box(int material, const glm::vec3& center, const glm::vec3& size) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      glm::vec3 normal(0.0f);
      normal[axis] = sign;
      // As add_quad lays its sides: x first, but for faces along X and Y.
      const glm::vec2 face = axis == 0   ? glm::vec2(size.z, size.y)
                             : axis == 1 ? glm::vec2(size.z, size.x)
                                         : glm::vec2(size.x, size.y);
      add_quad(material, center + 0.5f * normal * size, normal, face);
    }
  }
}

void GltfWriter::add_light(const TestLight& l) {
  use_extension(root_, "KHR_lights_punctual");
  Json light{{"type", l.type}, {"intensity", l.intensity}, {"color", json(l.color)}};
  if (l.range > 0.0f) light["range"] = l.range;
  if (l.type == "spot") light["spot"] = {{"innerConeAngle", l.inner_cone}, {"outerConeAngle", l.outer_cone}};
  if (!l.extras.is_null()) light["extras"] = l.extras;
  Json& lights = root_["extensions"]["KHR_lights_punctual"]["lights"];
  lights.push_back(std::move(light));
  add_child({{"translation", json(l.position)},
             {"rotation", turned_to(l.direction)},
             {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
}

void GltfWriter::add_clip_box(const std::string& name, const glm::vec3& center, const glm::vec3& half_size) {
  add_child(
      {{"translation", json(center)}, {"extras", {{"clip_volume", {{"name", name}, {"half_size", json(half_size)}}}}}});
}

void GltfWriter::add_ambient_light(const glm::vec3& center, const glm::vec3& color, float range) {
  add_child(
      {{"translation", json(center)}, {"extras", {{"ambient_light", {{"color", json(color)}, {"range", range}}}}}});
}

void GltfWriter::add_orthographic_camera(const glm::vec3& eye, const glm::vec3& target, float half_height,
                                         float far_depth) {
  root_["cameras"].push_back(
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", half_height}, {"ymag", half_height}, {"znear", 0.01f}, {"zfar", far_depth}}}});
  add_child(
      {{"camera", root_["cameras"].size() - 1}, {"translation", json(eye)}, {"rotation", turned_to(target - eye)}});
}

Scene GltfWriter::load() const {
  const TemporaryFolder folder;
  Json root = root_;
  if (!bytes_.empty()) {
    root["buffers"] = Json::array({{{"byteLength", bytes_.size()}, {"uri", "scene.bin"}}});
    std::ofstream(folder.path() / "scene.bin", std::ios::binary) << bytes_;
  }
  for (std::size_t i = 0; i < images_.size(); ++i) image::save_png(folder.path() / image_name(i), images_[i]);
  const auto file = folder.path() / "scene.gltf";
  std::ofstream(file) << root;
  return Scene::load(file);
}

}  // namespace velarium::test
