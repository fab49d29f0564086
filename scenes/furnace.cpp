#include "scenes/scenes.hpp"
#include "scenes/shapes.hpp"

#include <fmt/core.h>

#include <glm/trigonometric.hpp>

#include <array>

namespace velarium::scene {
namespace {

constexpr int kColumns = 6;
constexpr float kRadius = 0.45f;  // metres, on a grid of one metre

struct Row {
  const char* name;
  float metallic, ior;
};

// A perfect mirror by metallic, one by index of refraction (0 means a reflectance of 1), half a metal, and white paint.
constexpr std::array<Row, 4> kRows{{
    {"metal", 1.0f, 1.5f},
    {"full reflectance", 0.0f, 0.0f},
    {"half metal", 0.5f, 1.5f},
    {"white paint", 0.0f, 1.5f},
}};

Material material(const Row& row, int column) {
  Material m;
  m.name = fmt::format("{} {}", row.name, column);
  m.metallic = row.metallic;
  m.ior = row.ior;
  m.perceptual_roughness = static_cast<float>(column) / static_cast<float>(kColumns - 1);
  return m;
}

}  // namespace

Scene furnace_scene() {
  SceneBuilder builder("furnace");
  for (std::size_t row = 0; row < kRows.size(); ++row) {
    for (int column = 0; column < kColumns; ++column) {
      Material m = material(kRows[row], column);
      const std::string name = m.name;
      const auto mesh = builder.add_mesh(name, uv_sphere(kRadius, 32, 64), builder.add_material(std::move(m)));
      const float x = static_cast<float>(column) - 0.5f * (kColumns - 1);
      const float y = 0.5f * static_cast<float>(kRows.size() - 1) - static_cast<float>(row);
      builder.place_mesh(mesh, {x, y, 0.0f});
    }
  }
  builder.place_camera(glm::radians(19.5f), 16.0f / 9.0f, {0.0f, 0.0f, 12.0f}, glm::vec3(0.0f));
  Scene scene = std::move(builder).take();
  scene.environment = "white";
  return scene;
}

}  // namespace velarium::scene
