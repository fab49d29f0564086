// Volumes that lights end at. The extras of a node make one: {"clip_volume": {"name": "hall", "half_size": [4, 2, 6]}}
// is a box about its origin; without a half_size the node's mesh is the volume, which must be convex, and is not drawn.
// The extras of a light name the one it ends at: {"clip_volume": "hall"}.

#include "scene/gltf_parts.hpp"

#include <fmt/core.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace velarium::scene::gltf {

namespace {

// Each lit pixel asks each plane, so that a sphere of thousands of faces is a mistake.
constexpr std::size_t kMostPlanes = 64;

// Faces may lie this far from flat and from convex, as a share of the volume's size: what 16-bit positions leave.
constexpr float kRounding = 1e-4f;

// Two unit normals of the same face differ less than this in cosine: a thousandth of a radian.
constexpr float kSameDirection = 1e-6f;

std::vector<glm::vec4> box_planes(const Aabb& box) {
  return {{1, 0, 0, -box.min.x}, {-1, 0, 0, box.max.x}, {0, 1, 0, -box.min.y},
          {0, -1, 0, box.max.y}, {0, 0, 1, -box.min.z}, {0, 0, -1, box.max.z}};
}

float distance_to(const glm::vec4& plane, const glm::vec3& point) {
  return glm::dot(glm::vec3(plane), point) + plane.w;
}

bool is_same(const glm::vec4& a, const glm::vec4& b, float rounding) {
  return glm::dot(glm::vec3(a), glm::vec3(b)) > 1.0f - kSameDirection && std::abs(a.w - b.w) <= rounding;
}

// The triangles that make a volume.
struct Hull {
  std::vector<const Primitive*> primitives;
  Aabb bounds;

  [[nodiscard]] float rounding() const { return kRounding * glm::length(bounds.max - bounds.min); }

  // Planes of all faces, and of the box around them: where faces are missing, the box closes the volume. One more than
  // there may be, where there are too many.
  [[nodiscard]] std::vector<glm::vec4> planes() const {
    std::vector<glm::vec4> planes = box_planes(bounds);
    for (const Primitive* primitive : primitives) {
      const auto& indices = primitive->indices;
      for (std::size_t i = 0; i + 2 < indices.size() && planes.size() <= kMostPlanes; i += 3)
        add_face(&indices[i], primitive->vertices.positions, planes);
    }
    return planes;
  }

  [[nodiscard]] bool is_before(const std::vector<glm::vec4>& planes) const {
    return std::ranges::all_of(primitives, [&](const Primitive* primitive) {
      return std::ranges::all_of(primitive->vertices.positions, [&](const glm::vec3& point) {
        return std::ranges::all_of(planes,
                                   [&](const glm::vec4& plane) { return distance_to(plane, point) >= -rounding(); });
      });
    });
  }

 private:
  // Whichever way the triangle winds, its inner side is that of the middle.
  void add_face(const std::uint32_t* index, const std::vector<glm::vec3>& points,
                std::vector<glm::vec4>& planes) const {
    const glm::vec3 &a = points[index[0]], &b = points[index[1]], &c = points[index[2]];
    const glm::vec3 across = glm::cross(b - a, c - a);
    const float area = glm::length(across);
    if (!(area > rounding() * rounding())) return;
    const glm::vec3 normal = across / area;
    glm::vec4 plane(normal, -glm::dot(normal, a));
    if (distance_to(plane, 0.5f * (bounds.min + bounds.max)) < 0.0f) plane = -plane;
    if (std::ranges::none_of(planes, [&](const glm::vec4& other) { return is_same(plane, other, rounding()); }))
      planes.push_back(plane);
  }
};

Hull hull_of(const Scene& scene, const Node& node) {
  Hull hull;
  for (const std::uint32_t number : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
    const Primitive& primitive = scene.primitives[number];
    if (primitive.topology != Topology::triangles) continue;
    hull.primitives.push_back(&primitive);
    for (const glm::vec3& point : primitive.vertices.positions) hull.bounds.add(point);
  }
  return hull;
}

// Extras belong to applications and may be anything, so what does not fit is left out with a warning: false then.
bool ignore(const Value& value, const std::string& reason) {
  value.warn(reason + "; it is ignored");
  return false;
}

bool take_mesh(const Value& value, const Scene& scene, const Node& node, ClipVolume& volume) {
  const Hull hull = node.mesh == kNone ? Hull() : hull_of(scene, node);
  if (hull.primitives.empty()) return ignore(value, "has no half_size, and its node no mesh of triangles");
  volume.bounds = hull.bounds;
  volume.planes = hull.planes();
  if (volume.planes.size() > kMostPlanes)
    return ignore(value, fmt::format("is a mesh of more than {} faces", kMostPlanes));
  return hull.is_before(volume.planes) || ignore(value, "is a mesh that is not convex");
}

bool take_box(const Value& half_size, ClipVolume& volume) {
  const bool is_list = half_size.is_array() && half_size.size() == 3;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const float half = is_list && half_size.at(axis).is_number() ? half_size.at(axis).number() : 0.0f;
    if (!(half > 0.0f)) return ignore(half_size, "is not three numbers of metres above 0");
    volume.bounds.max[static_cast<int>(axis)] = half;
  }
  volume.bounds.min = -volume.bounds.max;
  volume.planes = box_planes(volume.bounds);
  return true;
}

std::int32_t find_volume(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.clip_volumes, name, &ClipVolume::name);
  return found == scene.clip_volumes.end() ? kNone : static_cast<std::int32_t>(found - scene.clip_volumes.begin());
}

bool take_name(const Value& value, const Scene& scene, ClipVolume& volume) {
  const Value name = value["name"];
  if (!name.is_text()) return ignore(value, "has no name");
  volume.name = name.text();
  return find_volume(scene, volume.name) == kNone || ignore(value, "has the name of an earlier volume");
}

void read_volume(const Value& value, Scene& scene, std::uint32_t index) {
  Node& node = scene.nodes[index];
  ClipVolume volume{.node = index};
  if (!take_name(value, scene, volume)) return;
  const Value half_size = value["half_size"];
  if (!(half_size ? take_box(half_size, volume) : take_mesh(value, scene, node, volume))) return;
  scene.clip_volumes.push_back(std::move(volume));
  if (half_size) return;
  node.mesh = node.skin = kNone;
  node.weights.clear();
  node.instances.clear();
}

}  // namespace

void read_clip_volumes(Context& context) {
  Scene& scene = context.scene;
  const Value nodes = context.root["nodes"];
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const Value value = nodes.at(i).extra_member("clip_volume");
    if (value.is_object()) read_volume(value, scene, i);
  }
  const Value lights = context.root["extensions"]["KHR_lights_punctual"]["lights"];
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    const Value name = lights.at(i).extra_member("clip_volume");
    if (!name) continue;
    if (name.is_text()) scene.lights[i].clip_volume = find_volume(scene, name.text());
    if (scene.lights[i].clip_volume == kNone) ignore(name, "is the name of no clip volume");
  }
}

}  // namespace velarium::scene::gltf
