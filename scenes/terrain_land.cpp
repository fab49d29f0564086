#include "scenes/terrain_land.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include <cmath>
#include <cstdint>

namespace velarium::scene::terrain {
namespace {

// An integer hash: the 32-bit finaliser "lowbias32" found by C. Wellons' search for avalanche (2018).
float hash(std::int32_t x, std::int32_t y) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u + static_cast<std::uint32_t>(y) * 0x85ebca77u;
  h = (h ^ h >> 16) * 0x7feb352du;
  h = (h ^ h >> 15) * 0x846ca68bu;
  return static_cast<float>((h ^ h >> 16) >> 8) / static_cast<float>(1u << 24);
}

struct Noise {
  float value;      // 0 to 1
  glm::vec2 slope;  // of the value by the place
};

// Random values at whole places, joined by the quintic whose second slope vanishes at both ends [Perlin 2002].
Noise value_noise(const glm::vec2& at) {
  const glm::vec2 cell = glm::floor(at), f = at - cell;
  const glm::vec2 u = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
  const glm::vec2 du = 30.0f * f * f * (f * (f - 2.0f) + 1.0f);
  const auto x = static_cast<std::int32_t>(cell.x), y = static_cast<std::int32_t>(cell.y);
  const float a = hash(x, y), b = hash(x + 1, y), c = hash(x, y + 1), d = hash(x + 1, y + 1);
  const float k = a - b - c + d;
  return {a + (b - a) * u.x + (c - a) * u.y + k * u.x * u.y, du * glm::vec2(b - a + k * u.y, c - a + k * u.x)};
}

// Octaves that are weaker where the land is steep already, as if water had washed it out: valleys are smooth and ridges
// rough [I. Quilez, "Value noise derivatives", 2008].
float eroded(glm::vec2 at, int octaves) {
  // A turn by the Pythagorean triple 3, 4, 5 and twice the frequency: octaves do not line up.
  const glm::mat2 next(1.6f, 1.2f, -1.2f, 1.6f);
  float sum = 0.0f, amplitude = 0.5f;
  glm::vec2 slope(0.0f);
  for (int i = 0; i < octaves; ++i) {
    const Noise noise = value_noise(at);
    slope += noise.slope;
    sum += amplitude * noise.value / (1.0f + glm::dot(slope, slope));
    amplitude *= 0.5f;
    at = next * at;
  }
  return sum;
}

constexpr float kLongest = 900.0f;  // metres, the first octave's cell
constexpr int kMostOctaves = 10;    // down to some 2 m
constexpr float kPeaks = 1150.0f;   // metres that a sum of 1 would rise

}  // namespace

float height(const glm::vec2& at, float finest) {
  const int shown = static_cast<int>(std::log2(kLongest / (4.0f * finest))) + 1;
  const float relief = kPeaks * eroded(at / kLongest + glm::vec2(3.7f, 8.2f), glm::clamp(shown, 1, kMostOctaves));
  // A basin with a lake, open towards the viewer, below mountains that rise to the far side.
  const glm::vec2 from_lake = (at - glm::vec2(0.0f, 420.0f)) / glm::vec2(820.0f, 1050.0f);
  const float basin = std::exp(-glm::dot(from_lake, from_lake));
  const float far = glm::smoothstep(700.0f, -1500.0f, at.y);
  return relief * (0.45f + 0.75f * far) * (1.0f - 0.75f * basin) - 60.0f - 120.0f * basin;
}

glm::vec3 color(const glm::vec3& position, const glm::vec3& normal) {
  constexpr glm::vec3 kSand{0.30f, 0.24f, 0.16f}, kMeadow{0.10f, 0.13f, 0.035f}, kForest{0.030f, 0.050f, 0.018f};
  constexpr glm::vec3 kRock{0.16f, 0.14f, 0.125f}, kSnow{0.85f, 0.87f, 0.90f};
  // Borders that wander with the land rather than follow one height.
  const float wander = value_noise(glm::vec2(position.x, position.z) / 55.0f).value - 0.5f;
  const float level = position.y + 60.0f * wander;
  glm::vec3 c = glm::mix(kSand, kMeadow, glm::smoothstep(3.0f, 14.0f, position.y + 6.0f * wander));
  c = glm::mix(c, kForest, glm::smoothstep(30.0f, 80.0f, level));
  c = glm::mix(c, kMeadow, glm::smoothstep(190.0f, 250.0f, level));
  c = glm::mix(c, kRock, glm::smoothstep(0.86f, 0.74f, normal.y + 0.15f * wander));
  const float snow = glm::smoothstep(270.0f, 350.0f, level) * glm::smoothstep(0.60f, 0.78f, normal.y);
  return glm::mix(c, kSnow, snow);
}

}  // namespace velarium::scene::terrain
