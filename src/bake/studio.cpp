#include "bake/studio.hpp"

#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <algorithm>
#include <array>

namespace velarium::bake {
namespace {

using glm::vec2;
using glm::vec3;

constexpr std::uint32_t kWidth = 1024, kHeight = 512;

// A glowing rectangle seen from the middle of the studio, at distance 1 along `direction`.
struct SoftBox {
  vec3 direction;  // need not be unit
  vec3 side;       // roughly along its width
  vec2 half_size;  // of the rectangle at distance 1
  float radiance;  // at its middle
  float rim;       // what is left of it at the edge: the light sits behind the middle of the cloth
};

constexpr std::array kBoxes{
    SoftBox{{0.0f, 1.0f, -0.05f}, {1.0f, 0.0f, 0.0f}, {0.62f, 0.4f}, 2.6f, 0.6f},     // overhead
    SoftBox{{-0.75f, 0.34f, 0.75f}, {0.7f, 0.0f, 0.7f}, {0.32f, 0.4f}, 7.5f, 0.45f},  // key
    SoftBox{{0.8f, 0.3f, -0.75f}, {0.7f, 0.0f, 0.8f}, {0.055f, 0.5f}, 20.0f, 0.7f},   // rim
    SoftBox{{1.0f, 0.1f, 0.6f}, {-0.5f, 0.0f, 0.9f}, {0.26f, 0.5f}, 0.6f, 0.5f},      // fill card
};

// Width of the soft edge, at distance 1: seven pixels of the picture, so that no edge is a staircase.
constexpr float kFeather = 0.045f;

// Hermite step from 0 at `low` to 1 at `high`.
float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

float box_radiance(const SoftBox& box, vec3 d) {
  const vec3 forward = glm::normalize(box.direction);
  const vec3 side = glm::normalize(box.side - glm::dot(box.side, forward) * forward);
  const float distance = glm::dot(d, forward);
  if (distance <= 0.0f) return 0.0f;
  const vec2 place(glm::dot(d, side) / distance, glm::dot(d, glm::cross(forward, side)) / distance);
  // Distance to a rectangle with rounded corners, negative inside.
  const vec2 corner = glm::abs(place) - box.half_size + vec2(kFeather);
  const float outside =
      glm::length(glm::max(corner, vec2(0.0f))) + std::min(std::max(corner.x, corner.y), 0.0f) - kFeather;
  const vec2 unit = place / box.half_size;
  const float falloff = 1.0f - (1.0f - box.rim) * std::min(0.5f * glm::dot(unit, unit), 1.0f);
  return box.radiance * falloff * smooth_step(0.5f * kFeather, -0.5f * kFeather, outside);
}

// Walls brighten upwards, where the overhead light reaches them; the floor brightens towards the middle of the studio.
// Both are darkest at the horizon, which gives metal an edge to show.
float surroundings(vec3 d) {
  constexpr float kHorizon = 0.05f, kCeiling = 0.14f, kFloor = 0.24f;
  return d.y >= 0.0f ? glm::mix(kHorizon, kCeiling, smooth_step(0.0f, 1.0f, d.y))
                     : glm::mix(kHorizon, kFloor, smooth_step(0.0f, 1.0f, -d.y));
}

float radiance(vec3 d) {
  float sum = surroundings(d);
  for (const auto& box : kBoxes) sum += box_radiance(box, d);
  return sum;
}

}  // namespace

image::FloatImage studio_environment() {
  image::FloatImage image{.width = kWidth, .height = kHeight};
  image.rgba.resize(4 * static_cast<std::size_t>(kWidth) * kHeight, 1.0f);
  parallel_for(kHeight, [&](std::size_t y) {
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const vec2 uv((static_cast<float>(x) + 0.5f) / kWidth, (static_cast<float>(y) + 0.5f) / kHeight);
      std::fill_n(&image.rgba[4 * (y * kWidth + x)], 3, radiance(shading::equirect_direction(uv)));
    }
  });
  return image;
}

}  // namespace velarium::bake
