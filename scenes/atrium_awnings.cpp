// Strips of cloth across the far half of the court, between poles that stand on the architraves.

#include "scenes/atrium_parts.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace velarium::scene::atrium {
namespace {

constexpr float kHalfSpan = 5.9f, kHeight = 5.35f, kSag = 0.85f, kHalfWidth = 0.85f;

// A catenary is within a centimetre of this parabola at such a sag.
float hang(float x) {
  const float part = x / kHalfSpan;
  return kHeight - kSag * (1.0f - part * part);
}

// Between its ropes the cloth hangs a little deeper, and in folds.
Primitive cloth() {
  return surface(64, 14, [](float s, float t) {
    const float x = (2.0f * s - 1.0f) * kHalfSpan, across = 2.0f * t - 1.0f;
    const float loose = 1.0f - across * across;
    const float folds = 0.035f * std::sin(9.0f * across + 2.0f * x) + 0.02f * std::sin(3.7f * x + 4.0f * across);
    const float y = hang(x) - 0.22f * loose + folds * (0.35f + loose);
    return SurfacePoint{{x, y, -across * kHalfWidth}, {x, across * kHalfWidth}};
  });
}

Primitive ropes() {
  Primitive whole;
  for (const float z : {-kHalfWidth, kHalfWidth}) {
    std::vector<glm::vec3> path;
    for (int i = 0; i <= 32; ++i) {
      const float x = (static_cast<float>(i) / 16.0f - 1.0f) * kHalfSpan;
      path.emplace_back(x, hang(x) + 0.01f, z);
    }
    append(whole, tube(path, 0.012f, 6));
    for (const float x : {-kHalfSpan, kHalfSpan}) {
      const std::array pole{glm::vec3(x, 4.4f, z), glm::vec3(x, kHeight + 0.15f, z)};
      append(whole, tube(pole, 0.035f, 10));
    }
  }
  return whole;
}

}  // namespace

void add_awnings(SceneBuilder& builder) {
  const auto saffron = builder.add_mesh("saffron awning", cloth(), kSaffron);
  const auto crimson = builder.add_mesh("crimson awning", cloth(), kCrimson);
  const auto rigging = builder.add_mesh("rigging", ropes(), kWood);
  constexpr float kPitch = 2.2f, kFarthest = -6.4f;
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 at(0.0f, 0.0f, kFarthest + kPitch * static_cast<float>(i));
    builder.place_mesh(i == 1 ? crimson : saffron, at);
    builder.place_mesh(rigging, at);
  }
}

}  // namespace velarium::scene::atrium
