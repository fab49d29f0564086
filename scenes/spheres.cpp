#include "scenes/scenes.hpp"
#include "scenes/shapes.hpp"

#include <fmt/core.h>

#include <glm/trigonometric.hpp>

#include <array>

namespace velarium::scene {
namespace {

constexpr int kColumns = 7;
constexpr float kRadius = 0.45f, kColumnStep = 1.0f, kRowStep = 1.15f;  // metres

struct Row {
  const char* name;
  glm::vec3 color;  // linear; of metals: reflectance at normal incidence
  float metallic;
};

// Metals after N. Hoffman, "Physically-Based Shading Models in Film and Game Production" (SIGGRAPH 2010 course),
// table 1. The rest are paints, between the darkest and the lightest that one finds. Front row last.
constexpr std::array<Row, 5> kRows{{
    {"iron", {0.56f, 0.57f, 0.58f}, 1.0f},
    {"copper", {0.95f, 0.64f, 0.54f}, 1.0f},
    {"gold", {1.00f, 0.71f, 0.29f}, 1.0f},
    {"red paint", {0.45f, 0.03f, 0.03f}, 0.0f},
    {"white paint", {0.80f, 0.80f, 0.80f}, 0.0f},
}};

// Equal steps of Ryse's smoothness, from 0 to 1, as glTF's roughness: alpha = (1 - 0.7 s)^6 = roughness^2.
float roughness_of_column(int column) {
  const float smoothness = static_cast<float>(column) / static_cast<float>(kColumns - 1);
  const float root = 1.0f - 0.7f * smoothness;
  return root * root * root;
}

Material material(const Row& row, int column) {
  Material m;
  m.name = fmt::format("{} {}", row.name, column);
  m.base_color = glm::vec4(row.color, 1.0f);
  m.metallic = row.metallic;
  m.perceptual_roughness = roughness_of_column(column);
  return m;
}

void add_ground(SceneBuilder& builder) {
  Material m;
  m.name = "ground";
  m.base_color = glm::vec4(0.18f, 0.18f, 0.18f, 1.0f);  // the photographer's grey card
  m.metallic = 0.0f;
  m.perceptual_roughness = 0.8f;
  const float x = 0.5f * kColumnStep * kColumns + 0.5f, z = 0.5f * kRowStep * kRows.size() + 0.4f;
  const auto mesh = builder.add_mesh(
      "ground", quad({glm::vec3(-x, 0, z), glm::vec3(x, 0, z), glm::vec3(x, 0, -z), glm::vec3(-x, 0, -z)}),
      builder.add_material(std::move(m)));
  builder.place_mesh(mesh, glm::vec3(0.0f));
}

}  // namespace

Scene spheres_scene() {
  SceneBuilder builder("spheres");
  add_ground(builder);
  for (std::size_t row = 0; row < kRows.size(); ++row) {
    for (int column = 0; column < kColumns; ++column) {
      Material m = material(kRows[row], column);
      const std::string name = m.name;
      const auto mesh = builder.add_mesh(name, uv_sphere(kRadius, 32, 64), builder.add_material(std::move(m)));
      const float x = kColumnStep * (static_cast<float>(column) - 0.5f * (kColumns - 1));
      const float z = kRowStep * (static_cast<float>(row) - 0.5f * static_cast<float>(kRows.size() - 1));
      builder.place_mesh(mesh, {x, kRadius, z});
    }
  }
  builder.place_camera(glm::radians(27.0f), 16.0f / 9.0f, {0.0f, 7.6f, 10.6f}, {0.0f, 0.1f, 0.15f});
  return std::move(builder).take();
}

}  // namespace velarium::scene
