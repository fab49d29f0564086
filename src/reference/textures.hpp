#pragma once

// Textures on the CPU: what a sampler of the device would read, from the scene's own 8-bit texels.

#include "scene/scene.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

namespace velarium::reference {

// A picture and its halves, down to one texel. Refers to the texels of the scene.
class MipChain {
 public:
  // srgb: red, green and blue are sRGB-encoded; smaller mips average their light.
  MipChain(const scene::Image& image, bool srgb);

  struct Level {
    std::uint32_t width, height;
    const std::uint8_t* rgba;
  };
  [[nodiscard]] const Level& level(std::size_t i) const { return levels_[i]; }
  [[nodiscard]] std::size_t level_count() const { return levels_.size(); }
  // Code values as linear numbers.
  [[nodiscard]] glm::vec4 texel(const Level& level, std::uint32_t x, std::uint32_t y) const;

 private:
  std::vector<Level> levels_;
  std::vector<std::vector<std::uint8_t>> smaller_;  // what levels_ refers to, from the second on
  const std::array<float, 256>& decoded_;
};

// A use of a texture by a material: bound to its picture. Without one it reads white.
struct BoundTexture {
  const MipChain* mips = nullptr;
  scene::Sampler sampler;
  glm::vec4 rows{1.0f, 0.0f, 0.0f, 1.0f};  // uv' = (dot(rows.xy, uv), dot(rows.zw, uv)) + offset
  glm::vec2 offset{0.0f};
  std::uint32_t uv_set = 0;

  [[nodiscard]] explicit operator bool() const { return mips != nullptr; }
  // log2 of the texels of the largest mip along one unit of the vertices' texture coordinates: the root of the two
  // axes.
  [[nodiscard]] float log2_texels_per_uv() const;
  // uv: as the vertices have it. lod: 0 is the largest mip. choice: in [0, 1); where the sampler mixes two mips, one of
  // them is read, as often as its share says: the mean over all choices is the sampler's answer.
  [[nodiscard]] glm::vec4 sample(const glm::vec2& uv, float lod, float choice) const;
};

// The pictures that the scene's materials use, once as colour and once as data where both are needed.
class Textures {
 public:
  explicit Textures(const scene::Scene& scene);
  [[nodiscard]] BoundTexture bind(const scene::TextureRef& ref, bool srgb) const;

 private:
  const scene::Scene& scene_;
  std::deque<MipChain> chains_;
  std::map<std::pair<std::int32_t, bool>, const MipChain*> index_;  // (image, sRGB)
};

}  // namespace velarium::reference
