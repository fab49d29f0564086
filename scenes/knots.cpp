#include "scenes/scenes.hpp"
#include "scenes/shapes.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace velarium::scene {
namespace {

constexpr float kDisc = 3.0f;  // metres, its radius
constexpr float kTube = 0.2f;  // radius of a knot's bar; that of the whole knot, lying, is 1.28, its half height 0.62
constexpr float kWidest = 1.28f, kHalfHeight = 0.62f;

// A trefoil knot that lies flat: twice around the axis while it winds three times around the bar's ring.
glm::vec3 trefoil(float s) {
  const float angle = s * glm::two_pi<float>();
  const float from_axis = 1.0f + 0.5f * std::cos(3.0f * angle);
  return {0.72f * from_axis * std::cos(2.0f * angle), 0.42f * std::sin(3.0f * angle),
          0.72f * from_axis * std::sin(2.0f * angle)};
}

Primitive knot() {
  return surface(96, 6, [](float s, float t) {
    constexpr float kStep = 1e-3f;
    const glm::vec3 forward = glm::normalize(trefoil(s + kStep) - trefoil(s - kStep));
    const glm::vec3 side = glm::normalize(glm::cross(forward, glm::vec3(0.0f, 1.0f, 0.0f)));
    const glm::vec3 up = glm::cross(side, forward);
    const float angle = t * glm::two_pi<float>();
    return SurfacePoint{trefoil(s) + kTube * (std::cos(angle) * side + std::sin(angle) * up), {s, t}};
  });
}

std::uint32_t add_gold(SceneBuilder& builder) {
  Material m;
  m.name = "gold";
  m.base_color = glm::vec4(1.00f, 0.71f, 0.29f, 1.0f);  // as of builtin:spheres
  m.metallic = 1.0f;
  m.perceptual_roughness = 0.25f;
  return builder.add_material(std::move(m));
}

void add_ground(SceneBuilder& builder) {
  Material m;
  m.name = "ground";
  m.base_color = glm::vec4(0.05f, 0.06f, 0.08f, 1.0f);
  m.metallic = 0.0f;
  m.perceptual_roughness = 0.4f;
  constexpr float kHalf = 1.25f * kDisc;
  const auto mesh = builder.add_mesh("ground",
                                     quad({glm::vec3(-kHalf, 0, kHalf), glm::vec3(kHalf, 0, kHalf),
                                           glm::vec3(kHalf, 0, -kHalf), glm::vec3(-kHalf, 0, -kHalf)}),
                                     builder.add_material(std::move(m)));
  builder.place_mesh(mesh, glm::vec3(0.0f));
}

}  // namespace

Scene knots_scene(std::uint32_t instances) {
  SceneBuilder builder("knots");
  add_ground(builder);
  const auto mesh = builder.add_mesh("knot", knot(), add_gold(builder));
  // Seeds of a sunflower: the golden angle between one and the next, and equal areas [H. Vogel, "A better way to
  // construct the sunflower head", 1979].
  const float golden_angle = glm::pi<float>() * (3.0f - std::sqrt(5.0f));
  const float spacing = kDisc / std::sqrt(static_cast<float>(instances));
  const float scale = 0.85f * spacing / kWidest;  // seeds are 1.7 apart where that of their areas' radii is 1
  for (std::uint32_t i = 0; i < instances; ++i) {
    const float radius = instances == 1 ? 0.0f : spacing * std::sqrt(static_cast<float>(i) + 0.5f);
    const float angle = golden_angle * static_cast<float>(i);
    builder.place_mesh(mesh, {radius * std::sin(angle), kHalfHeight * scale, radius * std::cos(angle)}, angle,
                       glm::vec3(scale));
  }
  builder.place_camera(glm::radians(27.0f), 16.0f / 9.0f, {0.0f, 9.0f, 10.0f}, {0.0f, 0.0f, 0.35f});
  return std::move(builder).take();
}

}  // namespace velarium::scene
