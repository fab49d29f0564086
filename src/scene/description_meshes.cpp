#include "scene/description_parts.hpp"
#include "scene/description_place.hpp"
#include "scene/gltf_parts.hpp"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace velarium::scene::description {
namespace {

// Vertices are numbered in 32 bits, and a corner of a flat triangle becomes one.
constexpr std::size_t kMostCorners = std::numeric_limits<std::uint32_t>::max();

// As the reader of files has it: lengths this near 1 are exact to a float.
constexpr float kUnitTolerance = 1e-5f;

template <class To, std::size_t N>
std::vector<To> vectors(const std::vector<std::array<float, N>>& from) {
  std::vector<To> to(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    for (std::size_t c = 0; c < N; ++c) to[i][static_cast<int>(c)] = from[i][c];
  return to;
}

void check_count(const Place& at, std::string_view member, std::size_t count, std::size_t positions) {
  if (count == 0 || count == positions) return;
  at.fail(member, fmt::format("has {} elements, but there are {} positions", count, positions));
}

void check_vertices(const Place& at, const MeshDescription& mesh) {
  const std::size_t positions = mesh.positions.size();
  if (positions < 3 || positions > kMostCorners)
    at.fail("positions", fmt::format("has {} elements, must have from 3 to {}", positions, kMostCorners));
  check_count(at, "normals", mesh.normals.size(), positions);
  check_count(at, "uv", mesh.uv.size(), positions);
  check_count(at, "colors", mesh.colors.size(), positions);
  at.all_finite("positions", mesh.positions);
  at.all_finite("normals", mesh.normals);
  at.all_finite("uv", mesh.uv);
  for (std::size_t i = 0; i < mesh.colors.size(); ++i) {
    const bool inside = std::ranges::all_of(mesh.colors[i], [](float value) { return value >= 0.0f && value <= 1.0f; });
    if (!inside) at.between(Place::element("colors", i), mesh.colors[i], 0.0f, 1.0f);
  }
}

std::vector<glm::vec3> unit_normals(const Place& at, const MeshDescription& mesh) {
  std::vector<glm::vec3> normals = vectors<glm::vec3>(mesh.normals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const float square = glm::dot(normals[i], normals[i]);
    if (!std::isnormal(square)) at.fail(Place::element("normals", i), "has no length, or one that is no number");
    if (std::abs(square - 1.0f) > kUnitTolerance) normals[i] *= 1.0f / std::sqrt(square);
  }
  return normals;
}

std::vector<std::uint32_t> indices_of(const Place& at, const MeshDescription& mesh) {
  const std::size_t positions = mesh.positions.size();
  std::vector<std::uint32_t> indices = mesh.indices;
  if (indices.empty()) {
    indices.resize(positions);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  if (indices.size() % 3 != 0 || indices.size() > kMostCorners) {
    at.fail(mesh.indices.empty() ? "positions" : "indices",
            fmt::format("has {} elements, but triangles need a multiple of 3 below 2^32", indices.size()));
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < positions) continue;
    at.fail(Place::element("indices", i), fmt::format("is {}, but there are {} positions", indices[i], positions));
  }
  return indices;
}

// Where a program names no material, ours: the tables' own default is that of files, which is metallic.
std::int32_t default_material(const SceneDescription& description, Scene& scene) {
  if (scene.materials.size() == description.materials.size()) {
    SceneDescription defaults;
    defaults.materials.emplace_back();
    Scene made;
    add_materials(defaults, made);
    scene.materials.push_back(std::move(made.materials.front()));
  }
  return static_cast<std::int32_t>(description.materials.size());
}

void check_uv(const Place& at, const MeshDescription& mesh, const Material& material) {
  if (!mesh.uv.empty()) return;
  for (const TextureRef* ref : gltf::texture_refs(material))
    if (ref->present()) at.fail("uv", "is empty, but the mesh's material has textures");
}

Primitive primitive_of(const Place& at, const MeshDescription& mesh, const SceneDescription& description,
                       Scene& scene) {
  check_vertices(at, mesh);
  Primitive primitive;
  primitive.material = at.reference("material", mesh.material, description.materials.size(), "materials");
  if (primitive.material == kNone) primitive.material = default_material(description, scene);
  check_uv(at, mesh, scene.materials[static_cast<std::size_t>(primitive.material)]);
  primitive.vertices.positions = vectors<glm::vec3>(mesh.positions);
  primitive.vertices.normals = unit_normals(at, mesh);
  primitive.uv[0] = vectors<glm::vec2>(mesh.uv);
  primitive.colors = vectors<glm::vec4>(mesh.colors);
  primitive.indices = indices_of(at, mesh);
  return primitive;
}

}  // namespace

void add_meshes(const SceneDescription& description, Scene& scene) {
  for (const MeshDescription& mesh : description.meshes) {
    const auto number = static_cast<std::uint32_t>(scene.meshes.size());
    scene.primitives.push_back(primitive_of(Place("meshes", number), mesh, description, scene));
    scene.meshes.push_back({mesh.name, {number}, {}});
  }
}

}  // namespace velarium::scene::description
