// Any number of lights with the power of the torches, for measuring how a renderer's time grows with lights.

#include "scenes/atrium_parts.hpp"
#include "scenes/scenes.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

constexpr std::uint32_t kSpotEvery = 4;                  // a quarter are spots
constexpr float kInnerCone = 0.45f, kOuterCone = 0.75f;  // radians from the axis: a light with a shade
constexpr float kWallDistance = 0.3f;                    // metres that lights keep from walls
constexpr float kLowest = 0.3f, kHighest = 3.6f;         // metres above the court

// Solid angle of the cone, weighted by the square of KHR_lights_punctual's ramp, which is linear in the cosine: 2 pi
// (1 - c_inner) inside, and a third of the rest.
float spot_solid_angle() {
  const float inner = std::cos(kInnerCone), outer = std::cos(kOuterCone);
  return glm::two_pi<float>() * (1.0f - inner + (inner - outer) / 3.0f);
}

// The additive recurrence whose points keep the largest distances in three dimensions: steps are powers of 1 / g, the
// root of x^4 = x + 1 [M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018].
glm::vec3 spread(std::uint32_t i) {
  constexpr double kG = 1.22074408460575947536;
  const auto at = [i](double step) { return static_cast<float>(std::fmod(0.5 + step * (i + 1.0), 1.0)); };
  return {at(1.0 / kG), at(1.0 / (kG * kG)), at(1.0 / (kG * kG * kG))};
}

}  // namespace

void add_extra_lights(SceneBuilder& builder, std::uint32_t count) {
  const float full = 4.0f * glm::pi<float>();
  const float lumens = kTorchCandela * full * static_cast<float>(kTorches) / static_cast<float>(count);
  const glm::vec2 half = kWalls - kWallDistance;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool spot = i % kSpotEvery == kSpotEvery - 1;
    Light light;
    light.name = spot ? "shaded lamp" : "lamp";
    light.kind = spot ? LightKind::spot : LightKind::point;
    light.color = kFireColor;
    light.inner_cone = kInnerCone;
    light.outer_cone = kOuterCone;
    light.intensity = lumens / (spot ? spot_solid_angle() : full);
    // Ends where its illuminance is that of a torch at its end, so that lights overlap as much, however many there are.
    light.range = kTorchRange * std::sqrt(light.intensity / kTorchCandela);
    const glm::vec3 at = spread(i);
    // Near enough to the floor to light it, however short the range is.
    const float height = std::min(kLowest + (spot ? 0.5f : 0.4f * at.y) * light.range, kHighest);
    const glm::quat down = glm::angleAxis(-glm::half_pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
    builder.place_light(std::move(light), {(2.0f * at.x - 1.0f) * half.x, height, (2.0f * at.z - 1.0f) * half.y}, down);
  }
}

}  // namespace velarium::scene::atrium
