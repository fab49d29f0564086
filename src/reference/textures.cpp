#include "reference/textures.hpp"

#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace velarium::reference {
namespace {

using Codes = std::array<float, 256>;

Codes make_codes(bool srgb) {
  Codes codes{};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const float value = static_cast<float>(i) / 255.0f;
    codes[i] = srgb ? shading::srgb_decode_channel(value) : value;
  }
  return codes;
}

const Codes& codes_of(bool srgb) {
  static const Codes kSrgb = make_codes(true), kData = make_codes(false);
  return srgb ? kSrgb : kData;
}

// The code whose decoded value is nearest.
std::uint8_t nearest_code(float value, const Codes& codes) {
  const auto above = std::lower_bound(codes.begin(), codes.end(), value);
  if (above == codes.begin()) return 0;
  if (above == codes.end()) return 255;
  const auto below = above - 1;
  return static_cast<std::uint8_t>((value - *below < *above - value ? below : above) - codes.begin());
}

// The two texels that a texel of the next mip lies between, as a linear filter reads them in a blit by halves.
struct Halving {
  std::uint32_t first, second;
  float weight;  // of the second
};

Halving halve(std::uint32_t i, std::uint32_t from, std::uint32_t to) {
  const float center = (static_cast<float>(i) + 0.5f) * static_cast<float>(from) / static_cast<float>(to) - 0.5f;
  const auto first = static_cast<std::uint32_t>(std::max(center, 0.0f));
  return {first, std::min(first + 1, from - 1), std::max(center, 0.0f) - static_cast<float>(first)};
}

std::vector<std::uint8_t> smaller_mip(const MipChain& chain, const MipChain::Level& from, std::uint32_t width,
                                      std::uint32_t height, const Codes& color) {
  std::vector<std::uint8_t> rgba(4 * std::size_t{width} * height);
  std::uint8_t* to = rgba.data();
  for (std::uint32_t y = 0; y < height; ++y) {
    const Halving row = halve(y, from.height, height);
    for (std::uint32_t x = 0; x < width; ++x, to += 4) {
      const Halving column = halve(x, from.width, width);
      const auto along = [&](std::uint32_t line) {
        return glm::mix(chain.texel(from, column.first, line), chain.texel(from, column.second, line), column.weight);
      };
      const glm::vec4 value = glm::mix(along(row.first), along(row.second), row.weight);
      for (int c = 0; c < 3; ++c) to[c] = nearest_code(value[c], color);
      to[3] = nearest_code(value.w, codes_of(false));
    }
  }
  return rgba;
}

std::uint32_t wrapped(std::int64_t i, std::uint32_t size, scene::Wrap wrap) {
  const auto n = static_cast<std::int64_t>(size);
  if (wrap == scene::Wrap::clamp_to_edge) return static_cast<std::uint32_t>(std::clamp<std::int64_t>(i, 0, n - 1));
  const std::int64_t period = wrap == scene::Wrap::repeat ? n : 2 * n;
  std::int64_t place = i % period;
  if (place < 0) place += period;
  return static_cast<std::uint32_t>(place < n ? place : 2 * n - 1 - place);
}

// Where a coordinate lies among texels. Far outside the unit square nothing but the place within it counts.
float texel_coordinate(float u, std::uint32_t size, scene::Wrap wrap) {
  constexpr float kFarthest = 1e6f;  // beyond, and for what is not a number, floats hold no place within a period
  if (!(std::abs(u) < kFarthest)) return 0.0f;
  const float period = wrap == scene::Wrap::mirrored_repeat ? 2.0f : 1.0f;
  const float inside =
      wrap == scene::Wrap::clamp_to_edge ? std::clamp(u, -1.0f, 2.0f) : u - period * std::floor(u / period);
  return inside * static_cast<float>(size);
}

glm::vec4 read_nearest(const MipChain& mips, const MipChain::Level& level, const scene::Sampler& s, glm::vec2 uv) {
  const float x = std::floor(texel_coordinate(uv.x, level.width, s.wrap_u));
  const float y = std::floor(texel_coordinate(uv.y, level.height, s.wrap_v));
  return mips.texel(level, wrapped(static_cast<std::int64_t>(x), level.width, s.wrap_u),
                    wrapped(static_cast<std::int64_t>(y), level.height, s.wrap_v));
}

glm::vec4 read_linear(const MipChain& mips, const MipChain::Level& level, const scene::Sampler& s, glm::vec2 uv) {
  const float x = texel_coordinate(uv.x, level.width, s.wrap_u) - 0.5f;
  const float y = texel_coordinate(uv.y, level.height, s.wrap_v) - 0.5f;
  const float left = std::floor(x), above = std::floor(y);
  const auto column = static_cast<std::int64_t>(left), row = static_cast<std::int64_t>(above);
  const std::uint32_t x0 = wrapped(column, level.width, s.wrap_u), x1 = wrapped(column + 1, level.width, s.wrap_u);
  const std::uint32_t y0 = wrapped(row, level.height, s.wrap_v), y1 = wrapped(row + 1, level.height, s.wrap_v);
  return glm::mix(glm::mix(mips.texel(level, x0, y0), mips.texel(level, x1, y0), x - left),
                  glm::mix(mips.texel(level, x0, y1), mips.texel(level, x1, y1), x - left), y - above);
}

std::size_t chosen_level(const scene::Sampler& sampler, std::size_t count, float lod, float choice) {
  if (!sampler.mipmapped || !(lod > 0.0f)) return 0;
  const float top = std::min(lod, static_cast<float>(count - 1));
  return static_cast<std::size_t>(top + (sampler.mip == scene::Filter::nearest ? 0.5f : choice));
}

}  // namespace

MipChain::MipChain(const scene::Image& image, bool srgb) : decoded_(codes_of(srgb)) {
  levels_.push_back({image.width, image.height, image.rgba.data()});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level from = levels_.back();
    const std::uint32_t width = std::max(from.width / 2, 1u), height = std::max(from.height / 2, 1u);
    smaller_.push_back(smaller_mip(*this, from, width, height, decoded_));
    levels_.push_back({width, height, smaller_.back().data()});
  }
}

glm::vec4 MipChain::texel(const Level& level, std::uint32_t x, std::uint32_t y) const {
  const std::uint8_t* code = level.rgba + 4 * (std::size_t{y} * level.width + x);
  return {decoded_[code[0]], decoded_[code[1]], decoded_[code[2]], static_cast<float>(code[3]) * (1.0f / 255.0f)};
}

float BoundTexture::texels_per_uv_area() const {
  const MipChain::Level& full = mips->level(0);
  return std::abs(rows.x * rows.w - rows.y * rows.z) * static_cast<float>(full.width) * static_cast<float>(full.height);
}

glm::vec4 BoundTexture::sample(const glm::vec2& uv, float lod, float choice) const {
  if (mips == nullptr) return glm::vec4(1.0f);
  const glm::vec2 place =
      glm::vec2(glm::dot(glm::vec2(rows.x, rows.y), uv), glm::dot(glm::vec2(rows.z, rows.w), uv)) + offset;
  const std::size_t last = mips->level_count() - 1;
  const auto& level = mips->level(std::min(chosen_level(sampler, last + 1, lod, choice), last));
  const scene::Filter filter = lod > 0.0f ? sampler.min : sampler.mag;
  return filter == scene::Filter::nearest ? read_nearest(*mips, level, sampler, place)
                                          : read_linear(*mips, level, sampler, place);
}

Textures::Textures(const scene::Scene& scene) : scene_(scene) {
  std::vector<std::pair<std::int32_t, bool>> wanted;
  const auto want = [&](const scene::TextureRef& ref, bool srgb) {
    if (!ref.present()) return;
    const std::int32_t image = scene.textures[static_cast<std::size_t>(ref.texture)].image;
    if (image != scene::kNone && index_.emplace(std::pair{image, srgb}, nullptr).second)
      wanted.push_back({image, srgb});
  };
  for (const scene::Material& m : scene.materials) {
    for (const auto* ref : {&m.base_color_texture, &m.emissive_texture, &m.specular_color_texture}) want(*ref, true);
    for (const auto* ref : {&m.metallic_roughness_texture, &m.normal_texture, &m.specular_texture}) want(*ref, false);
  }
  std::vector<std::optional<MipChain>> made(wanted.size());
  parallel_for(wanted.size(), [&](std::size_t i) {
    made[i].emplace(scene.images[static_cast<std::size_t>(wanted[i].first)], wanted[i].second);
  });
  for (std::size_t i = 0; i < wanted.size(); ++i) index_[wanted[i]] = &chains_.emplace_back(std::move(*made[i]));
}

BoundTexture Textures::bind(const scene::TextureRef& ref, bool srgb) const {
  if (!ref.present()) return {};
  const scene::Texture& texture = scene_.textures[static_cast<std::size_t>(ref.texture)];
  const auto found = index_.find({texture.image, srgb});
  if (found == index_.end()) return {};
  // KHR_texture_transform: uv' = T R S uv, where R = (cos, sin; -sin, cos).
  const float c = std::cos(ref.rotation), s = std::sin(ref.rotation);
  return {found->second,
          texture.sampler,
          {c * ref.scale.x, s * ref.scale.y, -s * ref.scale.x, c * ref.scale.y},
          ref.offset,
          ref.uv_set};
}

}  // namespace velarium::reference
