#include "scenes/shapes.hpp"

#include "core/assert.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <utility>

namespace velarium::scene {
namespace {

void add_vertex(Primitive& p, const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv) {
  p.vertices.positions.push_back(position);
  p.vertices.normals.push_back(normal);
  p.uv[0].push_back(uv);
  p.bounds.add(position);
}

// Flat where its corners are; elsewhere the normal is that of its diagonals.
void add_quad(Primitive& p, const std::array<glm::vec3, 4>& corners) {
  constexpr std::array<glm::vec2, 4> kUv{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  const auto first = static_cast<std::uint32_t>(p.vertex_count());
  const glm::vec3 normal = glm::normalize(glm::cross(corners[2] - corners[0], corners[3] - corners[1]));
  for (std::size_t i = 0; i < 4; ++i) add_vertex(p, corners[i], normal, kUv[i]);
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) p.indices.push_back(first + i);
}

}  // namespace

Primitive uv_sphere(float radius, std::uint32_t rings, std::uint32_t segments) {
  VEL_ASSERT(rings >= 2 && segments >= 3);
  Primitive p;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    const float v = static_cast<float>(ring) / static_cast<float>(rings);
    const float polar = v * glm::pi<float>();
    for (std::uint32_t segment = 0; segment <= segments; ++segment) {
      const float u = static_cast<float>(segment) / static_cast<float>(segments);
      const float azimuth = u * glm::two_pi<float>();
      const glm::vec3 n(std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth));
      add_vertex(p, radius * n, n, {u, v});
    }
  }
  const std::uint32_t row = segments + 1;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t segment = 0; segment < segments; ++segment) {
      const std::uint32_t a = ring * row + segment, b = a + row;  // above, below
      if (ring > 0) p.indices.insert(p.indices.end(), {a, b, a + 1});
      if (ring + 1 < rings) p.indices.insert(p.indices.end(), {a + 1, b, b + 1});
    }
  }
  return p;
}

Primitive quad(const std::array<glm::vec3, 4>& corners) {
  Primitive p;
  add_quad(p, corners);
  return p;
}

Primitive block(const std::array<glm::vec3, 4>& base, float height) {
  const glm::vec3 up(0.0f, height, 0.0f);
  Primitive p;
  add_quad(p, {base[0] + up, base[1] + up, base[2] + up, base[3] + up});
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec3 &a = base[i], &b = base[(i + 1) % 4];
    add_quad(p, {a, b, b + up, a + up});
  }
  return p;
}

SceneBuilder::SceneBuilder(const std::string& name) {
  scene_.source = "builtin:" + name;
  scene_.generator = "Velarium";
}

std::uint32_t SceneBuilder::add_material(Material material) {
  scene_.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::uint32_t SceneBuilder::add_mesh(const std::string& name, Primitive primitive, std::uint32_t material) {
  primitive.material = static_cast<std::int32_t>(material);
  scene_.primitives.push_back(std::move(primitive));
  scene_.meshes.push_back({name, {static_cast<std::uint32_t>(scene_.primitives.size() - 1)}, {}});
  return static_cast<std::uint32_t>(scene_.meshes.size() - 1);
}

Node& SceneBuilder::add_node(const std::string& name, const glm::vec3& position) {
  scene_.roots.push_back(static_cast<std::uint32_t>(scene_.nodes.size()));
  Node& node = scene_.nodes.emplace_back();
  node.name = name;
  node.translation = position;
  return node;
}

std::int32_t SceneBuilder::add_image(Image image) {
  scene_.images.push_back(std::move(image));
  return static_cast<std::int32_t>(scene_.images.size() - 1);
}

std::int32_t SceneBuilder::add_texture(Image image, const Sampler& sampler) {
  scene_.textures.push_back({add_image(std::move(image)), sampler});
  return static_cast<std::int32_t>(scene_.textures.size() - 1);
}

void SceneBuilder::place_mesh(std::uint32_t mesh, const glm::vec3& position, float yaw_rad, const glm::vec3& scale) {
  Node& node = add_node(scene_.meshes[mesh].name, position);
  node.mesh = static_cast<std::int32_t>(mesh);
  node.rotation = glm::angleAxis(yaw_rad, glm::vec3(0.0f, 1.0f, 0.0f));
  node.scale = scale;
}

void SceneBuilder::place_light(Light light, const glm::vec3& position, const glm::quat& rotation) {
  Node& node = add_node(light.name, position);
  node.rotation = rotation;
  node.light = static_cast<std::int32_t>(scene_.lights.size());
  scene_.lights.push_back(std::move(light));
}

void SceneBuilder::place_camera(float vertical_fov_rad, float aspect, const glm::vec3& eye, const glm::vec3& target,
                                const std::string& name) {
  Node& node = add_node(name, eye);
  node.rotation = glm::quatLookAt(glm::normalize(target - eye), glm::vec3(0.0f, 1.0f, 0.0f));
  node.camera = static_cast<std::int32_t>(scene_.cameras.size());
  Camera camera;
  camera.name = node.name;
  camera.aspect = aspect;
  camera.vertical_fov = vertical_fov_rad;
  camera.z_near = 0.05f;
  scene_.cameras.push_back(std::move(camera));
}

}  // namespace velarium::scene
