#pragma once

// Painting of tiling textures from code. Only integer hashes, additions, multiplications, divisions and square roots:
// the bytes are the same on every machine.

#include "scene/scene.hpp"

#include <cstdint>
#include <functional>

namespace velarium::scene::atrium {

// 0 to 1, of two cells and a seed.
[[nodiscard]] float cell_noise(int x, int y, std::uint32_t seed);

// 0 to 1, smooth, tiling after `period` units of p.
[[nodiscard]] float noise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed);

// The same, five octaves, each half as strong and twice as fine; 0.5 on average.
[[nodiscard]] float fractal_noise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed);

// Hermite step from 0 at `low` to 1 at `high`; falling where high < low.
[[nodiscard]] float smooth_step(float low, float high, float x);

struct Texel {
  glm::vec3 color;         // sRGB-encoded, 0 to 1
  float height = 0.0f;     // metres
  float roughness = 0.5f;  // glTF's perceptual roughness
  float metallic = 0.0f;
};

// uv from 0 to 1, v down; must tile.
using Painter = std::function<Texel(glm::vec2 uv)>;

struct Painting {
  Image base_color, normal, metallic_roughness;
};

// `metres`: what the texture's width and height measure on a wall, which gives heights their slope.
[[nodiscard]] Painting paint(std::uint32_t size, glm::vec2 metres, const Painter& painter);

}  // namespace velarium::scene::atrium
