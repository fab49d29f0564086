// The sun, low enough to shine under the sky's clouds and high enough to reach the court's floor past the awnings, and
// a lantern below the ceiling of a walk that throws the pattern of its glass.

#include "scenes/atrium_parts.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

// A ring of round panes of one colour, in units of half the picture.
struct Panes {
  int count;
  float from_middle, radius;
  glm::vec3 color;  // as the picture stores it, sRGB
};

constexpr Panes kPanes[] = {
    {1, 0.0f, 0.13f, {1.0f, 0.85f, 0.55f}},
    {8, 0.32f, 0.09f, {1.0f, 0.62f, 0.25f}},
    {12, 0.56f, 0.10f, {0.95f, 0.30f, 0.18f}},
    {24, 0.80f, 0.075f, {1.0f, 0.75f, 0.40f}},
};

// How far inside the nearest of the ring's panes, in the same units.
float inside(const Panes& panes, const glm::vec2& p) {
  const float step = glm::two_pi<float>() / static_cast<float>(panes.count);
  const float angle = step * std::round(std::atan2(p.y, p.x) / step);
  return panes.radius - glm::length(p - panes.from_middle * glm::vec2(std::cos(angle), std::sin(angle)));
}

Image glass() {
  constexpr std::uint32_t kSize = 256;
  constexpr float kTexel = 2.0f / kSize;
  Image image{.name = "lantern glass", .width = kSize, .height = kSize};
  for (std::uint32_t y = 0; y < kSize; ++y) {
    for (std::uint32_t x = 0; x < kSize; ++x) {
      const glm::vec2 p = kTexel * (glm::vec2(x, y) + 0.5f) - 1.0f;
      glm::vec3 color(0.0f);
      for (const Panes& panes : kPanes)
        color = glm::max(color, panes.color * std::clamp(inside(panes, p) / kTexel + 0.5f, 0.0f, 1.0f));
      for (int c = 0; c < 3; ++c) image.rgba.push_back(static_cast<std::uint8_t>(255.0f * color[c] + 0.5f));
      image.rgba.push_back(255);
    }
  }
  return image;
}

void add_sun(SceneBuilder& builder) {
  Light sun;
  sun.name = "sun";
  sun.kind = LightKind::directional;
  sun.color = {1.0f, 0.74f, 0.48f};
  sun.intensity = 4.0f;  // lux on the scale of the environment "sky", whose horizon is near 1 nit
  sun.angular_radius = glm::radians(0.2666f);
  // From above the glow of that sky.
  const glm::vec3 shines_to = glm::normalize(glm::vec3(0.42f, -0.62f, 1.0f));
  builder.place_light(std::move(sun), {0.0f, 20.0f, 0.0f}, glm::quatLookAt(shines_to, glm::vec3(0.0f, 1.0f, 0.0f)));
}

void add_lantern(SceneBuilder& builder) {
  Light lantern;
  lantern.name = "lantern";
  lantern.kind = LightKind::spot;
  lantern.color = {1.0f, 0.80f, 0.60f};
  lantern.intensity = 22.0f;
  lantern.range = kTorchRange;
  lantern.radius = 0.02f;
  lantern.inner_cone = 0.62f;
  lantern.outer_cone = 0.66f;
  lantern.projector = {.image = builder.add_image(glass()), .field_of_view = 2.0f * lantern.inner_cone};
  const glm::quat down = glm::angleAxis(-glm::half_pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
  builder.place_light(std::move(lantern), {7.5f, kCeiling - 0.35f, 1.6f}, down);
}

}  // namespace

void add_beams(SceneBuilder& builder) {
  add_sun(builder);
  add_lantern(builder);
}

}  // namespace velarium::scene::atrium
