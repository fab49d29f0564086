#include "upload/projectors.hpp"

#include "core/jobs.hpp"
#include "shading/host.hpp"
#include "upload/mips.hpp"
#include "upload/transfer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace velarium::upload {
namespace {

// Larger pictures are halved first: thrown on a wall, a texel of theirs is smaller than a pixel but very near the wall.
constexpr std::uint32_t kLargestLayer = 1024;

// Soft edges of small pictures need texels of their own: at a tenth of half the field, twelve.
constexpr std::uint32_t kSmallestLayer = 256;

bool same_picture(const scene::Projector& a, const scene::Projector& b) {
  return a.image == b.image && a.soft_edge == b.soft_edge;
}

TexelRows rows_of(scene::Image& image) {
  return {reinterpret_cast<std::byte*>(image.rgba.data()), std::size_t{4} * image.width, image.width, image.height};
}

scene::Image fitting(const scene::Image& image) {
  scene::Image result = image;
  while (std::max(result.width, result.height) > kLargestLayer) {
    scene::Image half{.width = std::max(result.width / 2, 1u), .height = std::max(result.height / 2, 1u)};
    half.rgba.resize(std::size_t{4} * half.width * half.height);
    make_mip(rows_of(result), rows_of(half), true);
    result = std::move(half);
  }
  return result;
}

// Linear light, times the opacity. x, y: clamped to the picture.
glm::vec3 light_at(const scene::Image& image, int x, int y) {
  const auto column = static_cast<std::size_t>(std::clamp(x, 0, static_cast<int>(image.width) - 1));
  const auto row = static_cast<std::size_t>(std::clamp(y, 0, static_cast<int>(image.height) - 1));
  const std::uint8_t* code = &image.rgba[4 * (row * image.width + column)];
  return shading::srgb_decode(glm::vec3(code[0], code[1], code[2]) / 255.0f) * (static_cast<float>(code[3]) / 255.0f);
}

glm::vec3 filtered(const scene::Image& image, const glm::vec2& texels) {
  const glm::vec2 corner = glm::floor(texels - 0.5f), share = texels - 0.5f - corner;
  const auto x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
  return glm::mix(glm::mix(light_at(image, x, y), light_at(image, x + 1, y), share.x),
                  glm::mix(light_at(image, x, y + 1), light_at(image, x + 1, y + 1), share.x), share.y);
}

// 0 at the border and outside, 1 from `soft_edge` inwards. inside: distance from the border as a share of half the
// field.
float fade(float inside, float soft_edge) {
  if (inside <= 0.0f) return 0.0f;
  const float t = soft_edge > 0.0f ? std::min(inside / soft_edge, 1.0f) : 1.0f;
  return t * t * (3.0f - 2.0f * t);
}

std::uint8_t encoded(float light) {
  return static_cast<std::uint8_t>(std::lround(255.0f * shading::srgb_encode_channel(std::clamp(light, 0.0f, 1.0f))));
}

scene::Image make_layer(const scene::Image& picture, float soft_edge, std::uint32_t size) {
  scene::Image layer{.width = size, .height = size};
  layer.rgba.resize(std::size_t{4} * size * size);
  const glm::vec2 texels(picture.width, picture.height);
  const glm::vec2 extent = texels / std::max(texels.x, texels.y);  // half of each side, in halves of the field
  parallel_for(size, [&](std::size_t y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      const glm::vec2 place = (glm::vec2(x, y) + 0.5f) * (2.0f / static_cast<float>(size)) - 1.0f;  // -1..1
      const glm::vec2 inside = extent - glm::abs(place);
      const float weight = fade(inside.x, soft_edge) * fade(inside.y, soft_edge);
      const glm::vec3 light = weight * filtered(picture, (0.5f + 0.5f * place / extent) * texels);
      std::uint8_t* code = &layer.rgba[4 * (y * size + x)];
      for (int c = 0; c < 3; ++c) code[c] = encoded(light[c]);
      code[3] = 255;
    }
  });
  return layer;
}

}  // namespace

std::vector<scene::Projector> projector_pictures(const scene::Scene& scene) {
  std::vector<scene::Projector> pictures;
  for (const auto& light : scene.lights)
    if (light.projector.present() && projector_layer(light.projector, pictures) == 0)
      pictures.push_back(light.projector);
  return pictures;
}

std::uint32_t projector_layer(const scene::Projector& projector, std::span<const scene::Projector> pictures) {
  const auto found = std::find_if(pictures.begin(), pictures.end(),
                                  [&](const scene::Projector& picture) { return same_picture(picture, projector); });
  return found == pictures.end() ? 0 : static_cast<std::uint32_t>(found - pictures.begin()) + 1;
}

std::vector<scene::Image> projector_layers(const scene::Scene& scene, std::span<const scene::Projector> pictures) {
  std::vector<scene::Image> fitted;
  std::uint32_t size = kSmallestLayer;
  for (const auto& picture : pictures) {
    fitted.push_back(fitting(scene.images[static_cast<std::size_t>(picture.image)]));
    size = std::max(size, std::bit_ceil(std::max(fitted.back().width, fitted.back().height)));
  }
  std::vector<scene::Image> layers;
  for (std::size_t i = 0; i < pictures.size(); ++i)
    layers.push_back(make_layer(fitted[i], pictures[i].soft_edge, size));
  return layers;
}

Projectors make_projectors(gpu::Device& device, const scene::Scene& scene) {
  Projectors projectors{.pictures = projector_pictures(scene)};
  const auto layers = projector_layers(scene, projectors.pictures);
  const std::uint32_t size = layers.empty() ? 1 : layers.front().width;
  std::vector<std::uint8_t> texels;
  for (const auto& layer : layers) texels.insert(texels.end(), layer.rgba.begin(), layer.rgba.end());
  if (layers.empty()) texels.assign(4, 0);
  const std::array sources{ImageSource{{.format = VK_FORMAT_R8G8B8A8_SRGB,
                                        .width = size,
                                        .height = size,
                                        .layers = std::max(static_cast<std::uint32_t>(layers.size()), 1u),
                                        .mips = gpu::full_mip_count(size, size),
                                        .array = true},
                                       std::as_bytes(std::span(texels))}};
  projectors.array = std::move(make_images(device, sources).front());
  return projectors;
}

}  // namespace velarium::upload
