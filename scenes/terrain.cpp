#include "core/jobs.hpp"
#include "scenes/scenes.hpp"
#include "scenes/shapes.hpp"
#include "scenes/terrain_land.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

namespace velarium::scene {
namespace {

constexpr std::uint32_t kPatches = 16;  // along each side

// Heights on a square grid with one more row on each side, for slopes.
class Grid {
 public:
  explicit Grid(std::uint32_t cells) : cells_(cells), step_(2.0f * terrain::kHalfSize / static_cast<float>(cells)) {
    heights_.resize(std::size_t{row_size()} * row_size());
    parallel_for(row_size(), [this](std::size_t row) {
      for (std::uint32_t column = 0; column < row_size(); ++column) {
        const glm::vec2 at = place(static_cast<float>(column) - 1.0f, static_cast<float>(row) - 1.0f);
        heights_[row * row_size() + column] = terrain::height(at, step_);
      }
    });
  }

  [[nodiscard]] std::uint32_t cells() const { return cells_; }
  [[nodiscard]] glm::vec3 position(std::uint32_t x, std::uint32_t z) const {
    const glm::vec2 at = place(static_cast<float>(x), static_cast<float>(z));
    return {at.x, height(x + 1, z + 1), at.y};
  }
  [[nodiscard]] glm::vec3 normal(std::uint32_t x, std::uint32_t z) const {
    return glm::normalize(
        glm::vec3(height(x, z + 1) - height(x + 2, z + 1), 2.0f * step_, height(x + 1, z) - height(x + 1, z + 2)));
  }

 private:
  [[nodiscard]] std::uint32_t row_size() const { return cells_ + 3; }
  [[nodiscard]] glm::vec2 place(float x, float z) const { return glm::vec2(x, z) * step_ - terrain::kHalfSize; }
  [[nodiscard]] float height(std::uint32_t column, std::uint32_t row) const {
    return heights_[std::size_t{row} * row_size() + column];
  }

  std::uint32_t cells_;
  float step_;  // metres
  std::vector<float> heights_;
};

Primitive patch(const Grid& grid, std::uint32_t patch_x, std::uint32_t patch_z) {
  const auto border = [&](std::uint32_t i) { return i * grid.cells() / kPatches; };
  const std::uint32_t x0 = border(patch_x), x1 = border(patch_x + 1), z0 = border(patch_z), z1 = border(patch_z + 1);
  Primitive p;
  for (std::uint32_t z = z0; z <= z1; ++z) {
    for (std::uint32_t x = x0; x <= x1; ++x) {
      const glm::vec3 position = grid.position(x, z), normal = grid.normal(x, z);
      p.vertices.positions.push_back(position);
      p.vertices.normals.push_back(normal);
      p.uv[0].emplace_back(position.x, position.z);
      p.colors.emplace_back(terrain::color(position, normal), 1.0f);
      p.bounds.add(position);
    }
  }
  const std::uint32_t row = x1 - x0 + 1;
  for (std::uint32_t z = 0; z + 1 <= z1 - z0; ++z) {
    for (std::uint32_t x = 0; x + 1 < row; ++x) {
      const std::uint32_t a = z * row + x, b = a + row;
      p.indices.insert(p.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  }
  return p;
}

void add_land(SceneBuilder& builder, std::uint32_t triangles) {
  Material m;
  m.name = "land";
  m.metallic = 0.0f;
  m.perceptual_roughness = 0.9f;
  const auto material = builder.add_material(std::move(m));
  const Grid grid(static_cast<std::uint32_t>(std::lround(std::sqrt(0.5 * triangles))));
  std::vector<Primitive> patches(std::size_t{kPatches} * kPatches);
  parallel_for(patches.size(), [&](std::size_t i) {
    patches[i] = patch(grid, static_cast<std::uint32_t>(i % kPatches), static_cast<std::uint32_t>(i / kPatches));
  });
  for (Primitive& p : patches) builder.place_mesh(builder.add_mesh("land", std::move(p), material), glm::vec3(0.0f));
}

void add_lake(SceneBuilder& builder) {
  Material m;
  m.name = "water";
  m.base_color = glm::vec4(0.010f, 0.030f, 0.035f, 1.0f);
  m.metallic = 0.0f;
  m.perceptual_roughness = 0.12f;
  m.ior = 1.33f;
  constexpr float kHalf = terrain::kHalfSize;
  const auto mesh = builder.add_mesh("lake",
                                     quad({glm::vec3(-kHalf, 0, kHalf), glm::vec3(kHalf, 0, kHalf),
                                           glm::vec3(kHalf, 0, -kHalf), glm::vec3(-kHalf, 0, -kHalf)}),
                                     builder.add_material(std::move(m)));
  builder.place_mesh(mesh, glm::vec3(0.0f));
}

void add_sun(SceneBuilder& builder) {
  Light sun;
  sun.name = "sun";
  sun.kind = LightKind::directional;
  sun.color = {1.0f, 0.72f, 0.48f};
  sun.intensity = 2.6f;  // lux on the scale of the environment "sky", whose horizon is near 1 nit
  const glm::vec3 shines_to = glm::normalize(glm::vec3(0.85f, -0.42f, -0.30f));
  builder.place_light(std::move(sun), {0.0f, 2000.0f, 0.0f}, glm::quatLookAt(shines_to, glm::vec3(0.0f, 1.0f, 0.0f)));
}

}  // namespace

Scene terrain_scene(std::uint32_t triangles) {
  SceneBuilder builder("terrain");
  add_land(builder, triangles);
  add_lake(builder);
  add_sun(builder);
  builder.place_camera(glm::radians(42.0f), 16.0f / 9.0f, {60.0f, 330.0f, 1720.0f}, {0.0f, 120.0f, 0.0f});
  Scene scene = std::move(builder).take();
  scene.environment = "sky";
  return scene;
}

}  // namespace velarium::scene
