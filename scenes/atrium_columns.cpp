// Composite columns: an Attic base, a fluted shaft with entasis, a capital of two rows of leaves below four volutes.
// Proportions after Vitruvius, books III and IV, a little stouter.

#include "scenes/atrium_parts.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace velarium::scene::atrium {
namespace {

constexpr float kFoot = 0.22f, kNeck = 2.84f;  // heights of the shaft's ends
constexpr float kFootRadius = 0.205f, kNeckRadius = 0.172f;
constexpr int kFlutes = 20;
constexpr float kTurn = glm::two_pi<float>();

// Straight for a third, then bent inwards.
float shaft_radius(float t) {
  const float upper = std::max(0.0f, (t - 0.33f) / 0.67f);
  return kFootRadius - (kFootRadius - kNeckRadius) * upper * upper * (1.4f - 0.4f * upper);
}

// Depth of the flute at s of the way around: circular, between narrow fillets, closed at both ends by a round.
float flute_depth(float s, float t) {
  const float place = s * kFlutes - std::floor(s * kFlutes);
  const float x = (place - 0.5f) / 0.40f;
  const float end = std::min(t, 1.0f - t) * (kNeck - kFoot);  // metres from the end of the shaft
  const float y = std::max(0.0f, 1.0f - (end - 0.03f) / 0.03f);
  const float inside = 1.0f - x * x - y * y;
  return inside > 0.0f ? 0.024f * std::sqrt(inside) : 0.0f;
}

Primitive shaft() {
  // Rows crowd where flutes end.
  constexpr std::array kRows{0.0f,  0.012f, 0.016f, 0.020f, 0.024f, 0.33f,  0.5f,
                             0.66f, 0.85f,  0.976f, 0.980f, 0.984f, 0.988f, 1.0f};
  const auto at = [&](float s, float t) {
    const float row = std::clamp(t, 0.0f, 1.0f) * (kRows.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(row), kRows.size() - 2);
    const float height = kRows[below] + (kRows[below + 1] - kRows[below]) * (row - static_cast<float>(below));
    const float radius = shaft_radius(height) - flute_depth(s, height);
    const float angle = s * kTurn, y = kFoot + (kNeck - kFoot) * height;
    return SurfacePoint{{radius * std::sin(angle), y, radius * std::cos(angle)}, {s * 1.5f, -y}};
  };
  return surface(kFlutes * 5, kRows.size() - 1, at);
}

Primitive base() {
  const Profile attic{{0.262f, 0.08f},  {0.275f, 0.09f},  {0.280f, 0.11f},  {0.275f, 0.13f}, {0.262f, 0.14f},
                      {0.245f, 0.145f}, {0.228f, 0.155f}, {0.226f, 0.168f}, {0.238f, 0.18f}, {0.246f, 0.183f},
                      {0.250f, 0.192f}, {0.246f, 0.203f}, {0.225f, 0.208f}, {0.206f, 0.22f}};
  Primitive whole = box({-0.275f, 0.0f, -0.275f}, {0.275f, 0.08f, 0.275f});
  append(whole, lathe(attic, 40, 1.5f));
  return whole;
}

// A leaf that clings to the bell and curls over at its tip, flattened from a tube: x across, z out.
Primitive leaf(float height, float width, float curl) {
  const auto at = [=](float s, float t) {
    const float angle = s * kTurn;
    const float lobes = 1.0f + 0.12f * std::sin(t * 19.0f);
    const float half = 0.5f * width * std::sqrt(std::max(0.0f, 1.0f - t * t * t * t)) * lobes;
    const float over = std::max(0.0f, t - 0.72f) / 0.28f;
    const float out = 0.012f + curl * (t * t * 0.35f + 0.65f * over * over);
    const float y = height * (t - 0.30f * over * over);
    const float rib = 0.010f * std::cos(angle);
    const float cup = 0.018f * std::sin(angle) * std::sin(angle);
    return SurfacePoint{{half * std::sin(angle), y, out + rib - cup}, {0.3f * s, -y}};
  };
  return surface(8, 7, at);
}

// A volute: a bar rolled up twice, in the plane of x and y, growing thinner inwards.
Primitive volute() {
  std::vector<glm::vec3> path;
  for (int i = 0; i <= 20; ++i) {
    const float part = static_cast<float>(i) / 20.0f;
    const float angle = 0.5f * glm::pi<float>() - part * 1.7f * kTurn, radius = 0.062f * (1.0f - 0.78f * part);
    path.emplace_back(0.215f + radius * std::cos(angle), 0.355f - 0.062f + radius * std::sin(angle), 0.0f);
  }
  Primitive whole = tube(path, 0.017f, 6);
  const std::array stem{glm::vec3(0.10f, 0.27f, 0.0f), glm::vec3(0.13f, 0.33f, 0.0f), glm::vec3(0.17f, 0.354f, 0.0f),
                        path.front()};
  append(whole, tube(stem, 0.017f, 6));
  return whole;
}

// The slab on top: a square with hollow sides and cut corners.
Primitive abacus() {
  const auto at = [](float s, float t) {
    constexpr std::array<glm::vec2, 6> kProfile{
        {{0.0f, 0.36f}, {0.94f, 0.36f}, {0.94f, 0.40f}, {1.0f, 0.415f}, {1.0f, 0.46f}, {0.0f, 0.46f}}};
    const float place = s * 4.0f - std::floor(s * 4.0f), along = 2.0f * place - 1.0f;
    const float reach = 0.225f + 0.055f * along * along * along * along;
    const glm::vec2 flat(0.27f * along, reach);
    const float angle = std::floor(s * 4.0f) * 0.25f * kTurn;
    const float row = std::clamp(t, 0.0f, 1.0f) * 5.0f;
    const auto below = std::min(static_cast<std::size_t>(row), std::size_t{4});
    const glm::vec2 edge = glm::mix(kProfile[below], kProfile[below + 1], row - static_cast<float>(below));
    const glm::vec2 q = edge.x * flat;
    return SurfacePoint{
        {std::cos(angle) * q.x + std::sin(angle) * q.y, edge.y, std::cos(angle) * q.y - std::sin(angle) * q.x},
        {q.x, q.y - edge.y}};
  };
  return surface(32, 5, at);
}

Primitive capital() {
  const Profile bell{{0.172f, 0.0f},  {0.186f, 0.008f}, {0.190f, 0.02f}, {0.184f, 0.032f}, {0.165f, 0.036f},
                     {0.160f, 0.15f}, {0.165f, 0.25f},  {0.190f, 0.32f}, {0.215f, 0.36f}};
  Primitive whole = lathe(bell, 32, 1.5f);
  for (int i = 0; i < 8; ++i) {
    const float angle = kTurn * static_cast<float>(i) / 8.0f;
    const auto turned = [&](float by) {
      return glm::translate(glm::rotate(glm::mat4(1.0f), by, glm::vec3(0, 1, 0)), glm::vec3(0, 0.036f, 0.152f));
    };
    append(whole, leaf(0.18f, 0.13f, 0.085f), turned(angle));
    append(whole, leaf(0.29f, 0.12f, 0.105f), turned(angle + kTurn / 16.0f));
  }
  for (int i = 0; i < 4; ++i)
    append(whole, volute(), glm::rotate(glm::mat4(1.0f), (static_cast<float>(i) + 0.5f) * 0.25f * kTurn, {0, 1, 0}));
  append(whole, abacus());
  return whole;
}

// Stands where the architraves of the long sides meet the arcades.
Primitive pier() {
  const Profile sides{{0.07f, 0.0f}, {0.07f, 0.14f}, {0.04f, 0.18f}, {0.04f, 0.22f}, {0.0f, 0.25f},  {0.0f, 0.8f},
                      {0.0f, 1.6f},  {0.0f, 2.4f},   {0.0f, 3.0f},   {0.02f, 3.02f}, {0.02f, 3.06f}, {0.0f, 3.08f},
                      {0.0f, 3.16f}, {0.05f, 3.2f},  {0.07f, 3.24f}, {0.07f, 3.3f}};
  return rectangle_moulding(glm::vec2(0.23f), sides, 0.23f);
}

}  // namespace

void add_columns(SceneBuilder& builder) {
  Primitive column = base();
  append(column, shaft());
  append(column, capital(), glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, kNeck, 0.0f)));
  const auto mesh = builder.add_mesh("column", std::move(column), kMarble);
  for (const int side : {1, 3}) {
    for (int i = -3; i <= 3; ++i) place(builder, mesh, on_side(side, 2.0f * static_cast<float>(i), 0.0f, kWalkFloor));
  }
  for (const int side : {0, 2}) {
    for (int i = 1; i < 5; ++i)
      place(builder, mesh, on_side(side, kBay * (static_cast<float>(i) - 2.5f), 0.0f, kWalkFloor), kArchedScale);
  }
  const auto corner = builder.add_mesh("corner pier", pier(), kMarble);
  for (const int side : {0, 2}) {
    for (const float end : {-1.0f, 1.0f}) place(builder, corner, on_side(side, end * kCourt.x, 0.0f, kWalkFloor));
  }
}

}  // namespace velarium::scene::atrium
