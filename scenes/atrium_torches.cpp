// Twenty torches on the walls and four stands at the pool, each with a flame and a light.

#include "scenes/atrium_parts.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

constexpr float kCupTop = 0.12f, kFlameMiddle = kCupTop + 0.13f;

Primitive cup() {
  return lathe({{0.0f, -0.10f},
                {0.018f, -0.09f},
                {0.022f, -0.05f},
                {0.035f, -0.03f},
                {0.055f, 0.02f},
                {0.075f, 0.09f},
                {0.085f, 0.115f},
                {0.08f, kCupTop},
                {0.065f, 0.09f},
                {0.0f, 0.06f}},
               24, 0.6f);
}

// Origin: the foot of the cup; the wall is 0.25 m behind, at +z.
Primitive sconce() {
  Primitive whole = cup();
  const std::array arm{glm::vec3(0, -0.22f, 0.25f), glm::vec3(0, -0.24f, 0.16f), glm::vec3(0, -0.20f, 0.06f),
                       glm::vec3(0, -0.12f, 0.01f), glm::vec3(0, -0.06f, 0.0f)};
  append(whole, tube(arm, 0.014f, 8));
  const Primitive plate =
      lathe({{0.075f, 0.0f}, {0.07f, 0.015f}, {0.045f, 0.02f}, {0.03f, 0.035f}, {0.0f, 0.04f}}, 24, 0.6f);
  append(whole, plate,
         glm::rotate(glm::translate(glm::mat4(1), {0, -0.22f, 0.25f}), -glm::half_pi<float>(), {1, 0, 0}));
  return whole;
}

// A candelabrum on three feet, the cup's foot at y = 0.
Primitive stand() {
  Primitive whole = cup();
  append(whole, lathe({{0.06f, -1.45f},
                       {0.07f, -1.42f},
                       {0.03f, -1.38f},
                       {0.022f, -1.2f},
                       {0.018f, -0.8f},
                       {0.028f, -0.78f},
                       {0.028f, -0.76f},
                       {0.017f, -0.74f},
                       {0.015f, -0.2f},
                       {0.03f, -0.16f},
                       {0.03f, -0.13f},
                       {0.018f, -0.1f}},
                      16, 0.6f));
  const std::array foot{glm::vec3(0.0f, -1.40f, 0.02f), glm::vec3(0.0f, -1.42f, 0.12f), glm::vec3(0.0f, -1.50f, 0.22f),
                        glm::vec3(0.0f, -1.585f, 0.25f), glm::vec3(0.0f, -1.585f, 0.29f)};
  for (int i = 0; i < 3; ++i)
    append(whole, tube(foot, 0.016f, 8),
           glm::rotate(glm::mat4(1), static_cast<float>(i) * glm::two_pi<float>() / 3.0f, {0, 1, 0}));
  return whole;
}

// Three tongues that lean apart.
Primitive flame() {
  const Primitive tongue = surface(10, 7, [](float s, float t) {
    const float angle = s * glm::two_pi<float>();
    const float radius = 0.045f * std::sin(glm::pi<float>() * std::sqrt(std::clamp(t, 0.0f, 1.0f))) * (1.15f - t);
    const float lean = 0.02f * std::sin(5.0f * t);
    return SurfacePoint{{radius * std::sin(angle) + lean, 0.26f * t, radius * std::cos(angle)}, {s, t}};
  });
  Primitive whole;
  for (int i = 0; i < 3; ++i) {
    const float turn = 2.1f * static_cast<float>(i);
    auto to = glm::rotate(glm::translate(glm::mat4(1), {0.0f, kCupTop - 0.05f, 0.0f}), turn, {0, 1, 0});
    to = glm::rotate(glm::translate(to, {0.022f, 0.0f, 0.0f}), -0.10f, {0, 0, 1});
    append(whole, tongue, glm::scale(to, glm::vec3(1.0f, 1.0f - 0.2f * static_cast<float>(i), 1.0f)));
  }
  return whole;
}

}  // namespace

void add_torches(SceneBuilder& builder, bool lit, float radius) {
  const auto bracket = builder.add_mesh("sconce", sconce(), kBronze);
  const auto candelabrum = builder.add_mesh("candelabrum", stand(), kBronze);
  const auto fire = builder.add_mesh("flame", flame(), kFlame);
  const auto add = [&](std::uint32_t holder, const Spot& spot) {
    place(builder, holder, spot);
    place(builder, fire, {spot.position, 3.1f * spot.position.x + 1.7f * spot.position.z});
    if (!lit) return;
    Light light;
    light.name = "torch";
    light.color = kFireColor;
    light.intensity = kTorchCandela;
    light.range = kTorchRange;
    light.radius = radius;
    builder.place_light(std::move(light), spot.position + glm::vec3(0.0f, kFlameMiddle, 0.0f), glm::quat(1, 0, 0, 0));
  };
  constexpr float kHeight = 2.0f;
  const float out = kWalls.x - kCourt.x - 0.25f;
  for (const int side : {1, 3}) {
    for (const float along : {-9.6f, -6.6f, -1.5f, 1.5f, 6.6f, 9.6f}) add(bracket, on_side(side, along, out, kHeight));
  }
  for (const int side : {0, 2}) {
    for (const float along : {-5.4f, -1.9f, 1.9f, 5.4f}) add(bracket, on_side(side, along, out, kHeight));
  }
  for (const float x : {-2.75f, 2.75f}) {
    for (const float z : {-4.35f, 4.35f}) add(candelabrum, {{x, 1.6f, z}, 0.0f});
  }
}

}  // namespace velarium::scene::atrium
