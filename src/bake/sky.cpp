#include "bake/sky.hpp"

#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::bake {
namespace {

using glm::vec2;
using glm::vec3;

constexpr std::uint32_t kWidth = 1024, kHeight = 512;

// Colours chosen by eye against photographs of clear evenings; radiance where 1 is the white of the picture.
constexpr vec3 kZenith{0.16f, 0.27f, 0.55f}, kGold{1.35f, 0.72f, 0.34f}, kLilac{0.62f, 0.46f, 0.55f};
constexpr vec3 kGlow{5.0f, 2.6f, 0.95f}, kGround{0.34f, 0.27f, 0.20f};
constexpr vec3 kSun{-0.42f, 0.2f, -1.0f};  // the middle of the glow; need not be unit

std::uint32_t hash(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = x * 0x9e3779b1u ^ (y * 0x85ebca77u + 0x165667b1u);
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return h ^ (h >> 15);
}

float lattice(std::int32_t x, std::int32_t y) {
  return static_cast<float>(hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) >> 8) * 0x1p-24f;
}

float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

float noise(vec2 p) {
  const vec2 cell = glm::floor(p);
  const vec2 f = p - cell;
  const vec2 w = f * f * (3.0f - 2.0f * f);
  const auto x = static_cast<std::int32_t>(cell.x), y = static_cast<std::int32_t>(cell.y);
  return glm::mix(glm::mix(lattice(x, y), lattice(x + 1, y), w.x),
                  glm::mix(lattice(x, y + 1), lattice(x + 1, y + 1), w.x), w.y);
}

float fractal_noise(vec2 p) {
  float sum = 0.0f, weight = 0.5f;
  for (int octave = 0; octave < 5; ++octave) {
    sum += weight * noise(p);
    weight *= 0.5f;
    p = 2.03f * vec2(0.8f * p.x - 0.6f * p.y, 0.6f * p.x + 0.8f * p.y) + 17.0f;
  }
  return sum;
}

// Share of the sky that cirrus covers: a flat layer, drawn out by the wind.
float clouds(vec3 d) {
  const vec2 layer = vec2(d.x, d.z) / (d.y + 0.12f);
  const vec2 wind(layer.x * 0.8f + layer.y * 0.6f, layer.y * 0.8f - layer.x * 0.6f);
  const vec2 warp(fractal_noise(wind * 0.7f + 31.0f), fractal_noise(wind * 0.7f + 57.0f));
  const float cover = fractal_noise(vec2(wind.x * 0.55f, wind.y * 1.5f) + 1.6f * warp);
  return smooth_step(0.46f, 0.78f, cover) * smooth_step(0.02f, 0.2f, d.y);
}

vec3 radiance(vec3 d) {
  const vec3 sun = glm::normalize(kSun);
  const float toward =
      0.5f + 0.5f * glm::dot(glm::normalize(vec2(d.x, d.z) + 1e-6f), glm::normalize(vec2(sun.x, sun.z)));
  const vec3 horizon = glm::mix(kLilac, kGold, toward * toward);
  const float angle_to_sun = std::acos(std::clamp(glm::dot(d, sun), -1.0f, 1.0f));
  const float glow = std::exp(-angle_to_sun * angle_to_sun / 0.045f) + 0.12f * std::exp(-angle_to_sun / 0.38f);
  const float height = std::max(d.y, 0.0f);
  vec3 sky = glm::mix(kZenith, horizon, std::exp(-height / 0.24f)) + kGlow * glow;
  if (d.y > 0.0f) {
    const vec3 lit = glm::mix(vec3(0.95f, 0.62f, 0.55f), vec3(1.9f, 1.02f, 0.55f), toward * toward * std::exp(-height));
    sky = glm::mix(sky, lit, 0.62f * clouds(d));
  }
  return glm::mix(sky, kGround, smooth_step(0.0f, 0.05f, -d.y));
}

}  // namespace

image::FloatImage sky_environment() {
  image::FloatImage image{.width = kWidth, .height = kHeight};
  image.rgba.resize(4 * static_cast<std::size_t>(kWidth) * kHeight, 1.0f);
  parallel_for(kHeight, [&](std::size_t y) {
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const vec2 uv((static_cast<float>(x) + 0.5f) / kWidth, (static_cast<float>(y) + 0.5f) / kHeight);
      const vec3 color = radiance(shading::equirect_direction(uv));
      for (int channel = 0; channel < 3; ++channel) image.rgba[4 * (y * kWidth + x) + channel] = color[channel];
    }
  });
  return image;
}

}  // namespace velarium::bake
