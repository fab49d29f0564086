// The arcades of the short sides: brick over marble columns, with marble around each arch.

#include "scenes/atrium_parts.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

constexpr float kSpringing = kWalkFloor + kArchedScale * kColumnHeight;
constexpr float kRadius = 0.96f, kHalfWidth = 0.5f * kBay, kHalfDepth = 0.20f;

float arch_height(float x) {
  return kSpringing + std::sqrt(std::max(0.0f, kRadius * kRadius - x * x));
}

// The wall above one arch: x across the bay; the side that faces +z at half the depth.
Primitive face(float top) {
  const auto at = [=](float s, float t) {
    // Denser towards the springing, where the arch is steep.
    const float turn = (std::clamp(s, 0.0f, 1.0f) - 0.5f) * 2.0f;
    const float edge = 0.06f;  // of the width, for the pier beside the arch
    const float x = std::abs(turn) > 1.0f - edge
                        ? std::copysign(kRadius + (std::abs(turn) - 1.0f + edge) / edge * (kHalfWidth - kRadius), turn)
                        : kRadius * std::sin(0.5f * glm::pi<float>() * turn / (1.0f - edge));
    const float low = arch_height(x), y = low + t * (top - low);
    return SurfacePoint{{x, y, kHalfDepth}, {x, -y}};
  };
  return surface(50, 4, at);
}

Primitive band(float inner, float outer, float half_depth) {
  // Around the arch from right to left, so that the profile's outside is the one seen: front, below, back.
  const auto strip = [](glm::vec2 from, glm::vec2 to) {
    return surface(28, 1, [=](float s, float t) {
      const float angle = glm::pi<float>() * s;
      const glm::vec2 place = glm::mix(from, to, t);  // radius, depth
      return SurfacePoint{{place.x * std::cos(angle), kSpringing + place.x * std::sin(angle), place.y},
                          {3.0f * s, place.x + place.y}};
    });
  };
  Primitive whole = strip({outer, half_depth}, {inner, half_depth});
  append(whole, strip({inner, half_depth}, {inner, -half_depth}));
  append(whole, strip({inner, -half_depth}, {outer, -half_depth}));
  append(whole, strip({outer, kHalfDepth}, {outer, half_depth}));
  append(whole, strip({outer, -half_depth}, {outer, -kHalfDepth}));
  return whole;
}

}  // namespace

void add_arches(SceneBuilder& builder) {
  Primitive wall = face(kCeiling);
  const glm::mat4 turned(glm::vec4(-1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 0, 0, 1));
  append(wall, face(kCorniceBottom), turned);
  append(wall, box({-kHalfWidth, kSpringing, -kHalfDepth}, {-kRadius, kSpringing + 0.02f, kHalfDepth}));
  append(wall, box({kRadius, kSpringing, -kHalfDepth}, {kHalfWidth, kSpringing + 0.02f, kHalfDepth}));
  const auto bricks = builder.add_mesh("arcade", std::move(wall), kBrick);
  Primitive ring = band(kRadius - 0.03f, kRadius + 0.11f, kHalfDepth + 0.04f);
  append(ring, band(kRadius - 0.01f, kRadius + 0.17f, kHalfDepth + 0.02f));
  const auto archivolt = builder.add_mesh("archivolt", std::move(ring), kMarble);
  for (const int side : {0, 2}) {
    for (int i = -2; i <= 2; ++i) {
      const Spot spot = on_side(side, kBay * static_cast<float>(i), 0.0f, 0.0f);
      place(builder, bricks, spot);
      place(builder, archivolt, spot);
    }
  }
}

}  // namespace velarium::scene::atrium
