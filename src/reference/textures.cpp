#include "reference/textures.hpp"

#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace velarium::reference {
namespace {

// For transforms that collapse the picture.
constexpr float kLeastTexels = 1e-30f;

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

// Finds codes of values. Steps of 1 / 4096 are shorter than those between codes, which are 1 / 3295 at least, so the
// code of a step is right or one too low.
class Encoder {
 public:
  explicit Encoder(const Codes& codes) {
    for (std::size_t i = 0; i + 1 < codes.size(); ++i) limits_[i] = 0.5f * (codes[i] + codes[i + 1]);
    limits_.back() = std::numeric_limits<float>::infinity();
    for (std::size_t step = 0; step < steps_.size(); ++step) {
      const float value = static_cast<float>(step) / kSteps;
      steps_[step] =
          static_cast<std::uint8_t>(std::upper_bound(limits_.begin(), limits_.end(), value) - limits_.begin());
    }
  }

  // The code whose decoded value is nearest. value: in [0, 1].
  [[nodiscard]] std::uint8_t operator()(float value) const {
    const std::uint8_t code = steps_[static_cast<std::size_t>(value * kSteps)];
    return static_cast<std::uint8_t>(value >= limits_[code] ? code + 1 : code);
  }

 private:
  static constexpr float kSteps = 4096.0f;
  std::array<float, 256> limits_;  // where the next code is nearer
  std::array<std::uint8_t, 4097> steps_;
};

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
                                      std::uint32_t height, const Encoder& color) {
  static const Encoder kAlpha(codes_of(false));
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
      for (int c = 0; c < 3; ++c) to[c] = color(value[c]);
      to[3] = kAlpha(value.w);
    }
  }
  return rgba;
}

// A coordinate in texels, brought into one period of the wrap mode, of which there is at most one texel more on each
// side. Far outside the unit square nothing but the place within the period counts.
float texel_coordinate(float u, std::int32_t size, scene::Wrap wrap) {
  constexpr float kFarthest = 1e6f;  // beyond, and for what is not a number, floats hold no place within a period
  if (!(std::abs(u) < kFarthest)) return 0.0f;
  const auto texels = static_cast<float>(size);
  if (wrap == scene::Wrap::repeat) return (u - std::floor(u)) * texels;
  if (wrap == scene::Wrap::clamp_to_edge) return std::clamp(u, 0.0f, 1.0f) * texels;
  return (u - 2.0f * std::floor(0.5f * u)) * texels;
}

// The texel that stands for number i, at most one outside of a period.
std::uint32_t wrapped(std::int32_t i, std::int32_t size, scene::Wrap wrap) {
  if (wrap == scene::Wrap::clamp_to_edge) return static_cast<std::uint32_t>(std::clamp(i, 0, size - 1));
  const std::int32_t period = wrap == scene::Wrap::repeat ? size : 2 * size;
  if (i < 0) i += period;
  if (i >= period) i -= period;
  return static_cast<std::uint32_t>(i < size ? i : 2 * size - 1 - i);
}

glm::vec4 read_nearest(const MipChain& mips, const MipChain::Level& level, const scene::Sampler& s, glm::vec2 uv) {
  const auto width = static_cast<std::int32_t>(level.width), height = static_cast<std::int32_t>(level.height);
  const auto x = static_cast<std::int32_t>(texel_coordinate(uv.x, width, s.wrap_u));
  const auto y = static_cast<std::int32_t>(texel_coordinate(uv.y, height, s.wrap_v));
  return mips.texel(level, wrapped(x, width, s.wrap_u), wrapped(y, height, s.wrap_v));
}

glm::vec4 read_linear(const MipChain& mips, const MipChain::Level& level, const scene::Sampler& s, glm::vec2 uv) {
  const auto width = static_cast<std::int32_t>(level.width), height = static_cast<std::int32_t>(level.height);
  // Never negative, so that casts round down; by one too high.
  const float x = texel_coordinate(uv.x, width, s.wrap_u) + 0.5f;
  const float y = texel_coordinate(uv.y, height, s.wrap_v) + 0.5f;
  const auto column = static_cast<std::int32_t>(x), row = static_cast<std::int32_t>(y);
  const std::uint32_t x0 = wrapped(column - 1, width, s.wrap_u), x1 = wrapped(column, width, s.wrap_u);
  const std::uint32_t y0 = wrapped(row - 1, height, s.wrap_v), y1 = wrapped(row, height, s.wrap_v);
  const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
  return glm::mix(glm::mix(mips.texel(level, x0, y0), mips.texel(level, x1, y0), fx),
                  glm::mix(mips.texel(level, x0, y1), mips.texel(level, x1, y1), fx), fy);
}

std::size_t chosen_level(const scene::Sampler& sampler, std::size_t count, float lod, float choice) {
  if (!sampler.mipmapped || !(lod > 0.0f)) return 0;
  const float top = std::min(lod, static_cast<float>(count - 1));
  return static_cast<std::size_t>(top + (sampler.mip == scene::Filter::nearest ? 0.5f : choice));
}

}  // namespace

MipChain::MipChain(const scene::Image& image, bool srgb) : decoded_(codes_of(srgb)) {
  levels_.push_back({image.width, image.height, image.rgba.data()});
  const Encoder encoder(decoded_);
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level from = levels_.back();
    const std::uint32_t width = std::max(from.width / 2, 1u), height = std::max(from.height / 2, 1u);
    smaller_.push_back(smaller_mip(*this, from, width, height, encoder));
    levels_.push_back({width, height, smaller_.back().data()});
  }
}

glm::vec4 MipChain::texel(const Level& level, std::uint32_t x, std::uint32_t y) const {
  const std::uint8_t* code = level.rgba + 4 * (std::size_t{y} * level.width + x);
  return {decoded_[code[0]], decoded_[code[1]], decoded_[code[2]], static_cast<float>(code[3]) * (1.0f / 255.0f)};
}

float BoundTexture::log2_texels_per_uv() const {
  const MipChain::Level& full = mips->level(0);
  const float texels = static_cast<float>(full.width) * static_cast<float>(full.height);
  return 0.5f * std::log2(std::max(std::abs(rows.x * rows.w - rows.y * rows.z) * texels, kLeastTexels));
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
