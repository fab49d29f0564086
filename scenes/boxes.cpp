#include "scenes/scenes.hpp"
#include "scenes/shapes.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

namespace velarium::scene {
namespace {

// Without gloss, so that a plane shows its light and nothing else.
Material matt(const char* name, const glm::vec3& color) {
  Material m;
  m.name = name;
  m.base_color = glm::vec4(color, 1.0f);
  m.metallic = 0.0f;
  m.perceptual_roughness = 1.0f;
  m.specular = 0.0f;
  return m;
}

void add_ground(SceneBuilder& builder) {
  constexpr float kHalf = 8.0f;
  const auto mesh = builder.add_mesh("ground",
                                     quad({glm::vec3(-kHalf, 0, kHalf), glm::vec3(kHalf, 0, kHalf),
                                           glm::vec3(kHalf, 0, -kHalf), glm::vec3(-kHalf, 0, -kHalf)}),
                                     builder.add_material(matt("ground", glm::vec3(0.5f))));
  builder.place_mesh(mesh, glm::vec3(0.0f));
}

void add_blocks(SceneBuilder& builder) {
  const auto clay = builder.add_material(matt("clay", {0.55f, 0.32f, 0.20f}));
  const auto add = [&](const char* name, const glm::vec3& size, const glm::vec3& foot, float yaw_deg) {
    const glm::vec3 half(0.5f * size.x, 0.0f, 0.5f * size.z);
    builder.place_mesh(builder.add_mesh(name, box(-half, half + glm::vec3(0.0f, size.y, 0.0f)), clay), foot,
                       glm::radians(yaw_deg));
  };
  add("tower", {0.7f, 1.7f, 0.7f}, {-1.5f, 0.0f, -0.5f}, 25.0f);
  add("step", {1.1f, 0.4f, 1.1f}, {0.2f, 0.0f, 0.7f}, -15.0f);
  add("cube", {0.35f, 0.35f, 0.35f}, {0.1f, 0.4f, 0.8f}, 35.0f);
}

void add_ball(SceneBuilder& builder) {
  Material paint = matt("blue paint", {0.05f, 0.12f, 0.35f});
  paint.specular = 1.0f;
  paint.perceptual_roughness = 0.4f;
  const auto mesh = builder.add_mesh("ball", uv_sphere(0.55f, 48, 96), builder.add_material(std::move(paint)));
  builder.place_mesh(mesh, {1.5f, 0.55f, -0.3f});
}

// Bars of three centimetres, a hand's breadth apart.
void add_fence(SceneBuilder& builder) {
  constexpr int kBars = 14;
  constexpr float kPitch = 0.17f, kHalf = 0.015f, kHeight = 1.1f;
  constexpr float kEnd = 0.5f * kPitch * kBars;
  Primitive fence;
  for (int i = 0; i < kBars; ++i) {
    const float x = kPitch * (static_cast<float>(i) + 0.5f) - kEnd;
    append(fence, box({x - kHalf, 0.0f, -kHalf}, {x + kHalf, kHeight, kHalf}));
  }
  for (const float y : {0.25f, 0.9f}) append(fence, box({-kEnd, y - kHalf, kHalf}, {kEnd, y + kHalf, 3.0f * kHalf}));
  const auto mesh =
      builder.add_mesh("fence", std::move(fence), builder.add_material(matt("iron", {0.12f, 0.12f, 0.13f})));
  builder.place_mesh(mesh, {0.7f, 0.0f, -1.7f}, glm::radians(-6.0f));
}

// Round holes in square cells, white around them.
Image pierced() {
  constexpr std::uint32_t kSize = 256, kCells = 4;
  constexpr float kHole = 0.36f;                               // radius, of a cell
  constexpr float kCell = static_cast<float>(kSize) / kCells;  // texels
  Image image{.name = "pierced", .width = kSize, .height = kSize};
  for (std::uint32_t y = 0; y < kSize; ++y) {
    for (std::uint32_t x = 0; x < kSize; ++x) {
      const auto from_middle = [](std::uint32_t texel) {
        return std::fmod((static_cast<float>(texel) + 0.5f) / kCell, 1.0f) - 0.5f;
      };
      // Coverage falls over the texel at the rim, so that the outline lies where alpha is a half.
      const float outside = (std::hypot(from_middle(x), from_middle(y)) - kHole) * kCell;
      const auto alpha = static_cast<std::uint8_t>(255.0f * glm::clamp(outside + 0.5f, 0.0f, 1.0f) + 0.5f);
      image.rgba.insert(image.rgba.end(), {255, 255, 255, alpha});
    }
  }
  return image;
}

void add_screen(SceneBuilder& builder) {
  constexpr float kHalf = 0.6f;
  Material m = matt("screen", {0.45f, 0.45f, 0.30f});
  m.base_color_texture = {.texture = builder.add_texture(pierced())};
  m.alpha_mode = AlphaMode::mask;
  m.double_sided = true;
  const auto mesh =
      builder.add_mesh("screen",
                       quad({glm::vec3(-kHalf, 0.0f, 0.0f), glm::vec3(kHalf, 0.0f, 0.0f),
                             glm::vec3(kHalf, 2.0f * kHalf, 0.0f), glm::vec3(-kHalf, 2.0f * kHalf, 0.0f)}),
                       builder.add_material(std::move(m)));
  builder.place_mesh(mesh, {-2.7f, 0.0f, 0.9f}, glm::radians(40.0f));
}

void add_sheet(SceneBuilder& builder) {
  constexpr float kHalf = 0.65f, kHeight = 1.1f;
  Material m = matt("sheet", {0.60f, 0.06f, 0.05f});
  m.base_color.a = 0.5f;
  m.alpha_mode = AlphaMode::blend;
  m.double_sided = true;
  const auto mesh = builder.add_mesh("sheet",
                                     quad({glm::vec3(-kHalf, 0, kHalf), glm::vec3(kHalf, 0, kHalf),
                                           glm::vec3(kHalf, 0, -kHalf), glm::vec3(-kHalf, 0, -kHalf)}),
                                     builder.add_material(std::move(m)));
  builder.place_mesh(mesh, {2.4f, kHeight, 1.2f}, glm::radians(20.0f));
}

// Each as bright on the ground as pictures at exposure 0 can take.
void add_light(SceneBuilder& builder, LightKind kind, float radius) {
  Light light;
  light.name = "light";
  light.kind = kind;
  (kind == LightKind::directional ? light.angular_radius : light.radius) = radius;
  const auto place = [&](const glm::vec3& from, const glm::vec3& to) {
    builder.place_light(light, from, glm::quatLookAt(glm::normalize(to - from), glm::vec3(0.0f, 1.0f, 0.0f)));
  };
  switch (kind) {
    case LightKind::directional:
      light.intensity = 3.0f;
      return place({-3.0f, 5.0f, -3.2f}, glm::vec3(0.0f));
    case LightKind::point:
      light.intensity = 30.0f;
      light.range = 20.0f;
      return place({-0.4f, 2.6f, -0.4f}, glm::vec3(0.0f));
    case LightKind::spot:
      light.intensity = 90.0f;
      light.range = 20.0f;
      light.inner_cone = glm::radians(28.0f);
      light.outer_cone = glm::radians(34.0f);
      return place({-3.6f, 4.2f, -2.4f}, {0.2f, 0.2f, 0.2f});
  }
}

}  // namespace

Scene boxes_scene(LightKind light, float radius, bool sheet) {
  SceneBuilder builder("boxes");
  add_ground(builder);
  add_blocks(builder);
  add_ball(builder);
  add_fence(builder);
  add_screen(builder);
  if (sheet) add_sheet(builder);
  add_light(builder, light, radius);
  builder.place_camera(glm::radians(36.0f), 16.0f / 9.0f, {0.4f, 4.4f, 7.4f}, {0.1f, 0.35f, 0.0f});
  Scene scene = std::move(builder).take();
  scene.environment = "none";
  return scene;
}

}  // namespace velarium::scene
