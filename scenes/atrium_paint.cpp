#include "scenes/atrium_paint.hpp"

#include "core/jobs.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

namespace velarium::scene::atrium {
namespace {

std::uint8_t to_byte(float unit) {
  return static_cast<std::uint8_t>(std::clamp(unit, 0.0f, 1.0f) * 255.0f + 0.5f);
}

Image empty_image(std::uint32_t size) {
  Image image{.width = size, .height = size};
  image.rgba.resize(4 * static_cast<std::size_t>(size) * size, 255);
  return image;
}

void set_texel(Image& image, std::size_t index, const glm::vec3& value) {
  for (int channel = 0; channel < 3; ++channel)
    image.rgba[4 * index + static_cast<std::size_t>(channel)] = to_byte(value[channel]);
}

int wrapped(int i, int period) {
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}

// Green points up in the picture, as glTF has it: against v.
void paint_normals(Image& image, const std::vector<float>& heights, glm::vec2 metres) {
  const std::size_t size = image.width;
  const float inverse_two_steps_x = 0.5f * static_cast<float>(size) / metres.x;
  const float inverse_two_steps_y = 0.5f * static_cast<float>(size) / metres.y;
  parallel_for(size, [&](std::size_t y) {
    const std::size_t above = (y + size - 1) % size * size, below = (y + 1) % size * size;
    for (std::size_t x = 0; x < size; ++x) {
      const float slope_x = heights[y * size + (x + 1) % size] - heights[y * size + (x + size - 1) % size];
      const float slope_y = heights[below + x] - heights[above + x];
      const glm::vec3 normal(-slope_x * inverse_two_steps_x, slope_y * inverse_two_steps_y, 1.0f);
      set_texel(image, y * size + x, 0.5f + 0.5f * glm::normalize(normal));
    }
  });
}

}  // namespace

float cell_noise(int x, int y, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u;
  h = (h + seed * 0xc2b2ae3du) ^ (h >> 15);
  h = (h ^ (h >> 13)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return static_cast<float>((h ^ (h >> 15)) >> 8) * 0x1p-24f;
}

float noise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed) {
  const glm::vec2 cell = glm::floor(p);
  const glm::vec2 f = p - cell;
  const glm::vec2 w = f * f * (3.0f - 2.0f * f);
  const int x0 = wrapped(static_cast<int>(cell.x), period.x), y0 = wrapped(static_cast<int>(cell.y), period.y);
  const int x1 = x0 + 1 == period.x ? 0 : x0 + 1, y1 = y0 + 1 == period.y ? 0 : y0 + 1;
  return glm::mix(glm::mix(cell_noise(x0, y0, seed), cell_noise(x1, y0, seed), w.x),
                  glm::mix(cell_noise(x0, y1, seed), cell_noise(x1, y1, seed), w.x), w.y);
}

float fractal_noise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed) {
  constexpr float kWhole = 1.0f - 1.0f / 32.0f;  // sum of the weights
  float sum = 0.0f, weight = 0.5f;
  for (std::uint32_t octave = 0; octave < 5; ++octave) {
    sum += weight * noise(p, period, seed + octave);
    weight *= 0.5f;
    p *= 2.0f;
    period *= 2;
  }
  return sum / kWhole;
}

float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

Painting paint(std::uint32_t size, glm::vec2 metres, const Painter& painter) {
  Painting painting{empty_image(size), empty_image(size), empty_image(size)};
  std::vector<float> heights(static_cast<std::size_t>(size) * size);
  parallel_for(size, [&](std::size_t y) {
    for (std::size_t x = 0; x < size; ++x) {
      const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const Texel texel = painter(center / static_cast<float>(size));
      const std::size_t index = y * size + x;
      set_texel(painting.base_color, index, texel.color);
      set_texel(painting.metallic_roughness, index, {1.0f, texel.roughness, texel.metallic});
      heights[index] = texel.height;
    }
  });
  paint_normals(painting.normal, heights, metres);
  return painting;
}

}  // namespace velarium::scene::atrium
