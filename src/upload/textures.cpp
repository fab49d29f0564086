#include "upload/textures.hpp"

#include "core/jobs.hpp"
#include "core/log.hpp"
#include "upload/transfer.hpp"

#include <algorithm>

namespace velarium::upload {
namespace {

constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};

VkSamplerAddressMode address_mode(scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::repeat:
      return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case scene::Wrap::mirrored_repeat:
      return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case scene::Wrap::clamp_to_edge:
      return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  }
  return VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

VkFilter filter(scene::Filter f) {
  return f == scene::Filter::nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
}

ImageSource image_source(const scene::Image& image, TexelKind kind) {
  return {{.format = kind == TexelKind::color ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
           .width = image.width,
           .height = image.height,
           .mips = gpu::full_mip_count(image.width, image.height)},
          std::as_bytes(std::span(image.rgba)),
          kind == TexelKind::normals ? MipFilter::normals : MipFilter::mean};
}

// The means of equal blocks, of as few pixels as bring the sides to `limit`.
scene::Image reduce(const scene::Image& image, std::uint32_t limit) {
  const std::uint32_t block = (std::max(image.width, image.height) + limit - 1) / limit;
  const auto blocks = [&](std::uint32_t size) { return (size + block - 1) / block; };
  scene::Image small{.name = image.name, .width = blocks(image.width), .height = blocks(image.height)};
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  parallel_for(small.height, [&](std::size_t row) {
    const auto top = static_cast<std::uint32_t>(row) * block, bottom = std::min(top + block, image.height);
    for (std::uint32_t column = 0; column < small.width; ++column) {
      const std::uint32_t left = column * block, right = std::min(left + block, image.width);
      std::array<std::uint64_t, 4> sum{};
      for (std::uint32_t y = top; y < bottom; ++y)
        for (std::uint32_t x = left; x < right; ++x)
          for (std::size_t c = 0; c < 4; ++c) sum[c] += image.rgba[4 * (std::size_t{y} * image.width + x) + c];
      const std::uint64_t count = std::uint64_t{bottom - top} * (right - left);
      for (std::size_t c = 0; c < 4; ++c)
        small.rgba[4 * (row * small.width + column) + c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    }
  });
  return small;
}

}  // namespace

std::array<const scene::TextureRef*, kSlotCount> slots_of(const scene::Material& m) {
  return {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,        &m.occlusion_texture,
          &m.emissive_texture,   &m.specular_texture,           &m.specular_color_texture};
}

TexelKind texel_kind(std::uint32_t slot) {
  if (slot == kSlotNormal) return TexelKind::normals;
  return slot == kSlotBaseColor || slot == kSlotEmissive || slot == kSlotSpecularColor ? TexelKind::color
                                                                                       : TexelKind::data;
}

gpu::SamplerDesc sampler_desc(const scene::Sampler& sampler, float anisotropy, float lod_bias) {
  const bool smooth = sampler.min == scene::Filter::linear && sampler.mag == scene::Filter::linear && sampler.mipmapped;
  return {.mag = filter(sampler.mag),
          .min = filter(sampler.min),
          .mip = sampler.mip == scene::Filter::nearest ? VK_SAMPLER_MIPMAP_MODE_NEAREST : VK_SAMPLER_MIPMAP_MODE_LINEAR,
          .wrap_u = address_mode(sampler.wrap_u),
          .wrap_v = address_mode(sampler.wrap_v),
          .mipmapped = sampler.mipmapped,
          .anisotropy = smooth ? anisotropy : 1.0f,
          .lod_bias = lod_bias};
}

Textures::Textures(gpu::Device& device, const scene::Scene& scene) : scene_(scene) {
  std::vector<ImageSource> sources;
  std::map<std::int32_t, scene::Image> reduced;  // of images too large for the device
  const auto fitted = [&](std::int32_t number, std::uint32_t limit) -> const scene::Image& {
    const auto& image = scene.images[static_cast<std::size_t>(number)];
    if (std::max(image.width, image.height) <= limit) return image;
    const auto [place, is_new] = reduced.try_emplace(number);
    if (!is_new) return place->second;
    place->second = reduce(image, limit);
    log_warning("{}: image {} of {} x {} pixels was scaled to {} x {}: the device takes {} a side", scene.source,
                number, image.width, image.height, place->second.width, place->second.height, limit);
    return place->second;
  };
  for (const auto& material : scene.materials) {
    const auto slots = slots_of(material);
    for (std::uint32_t slot = 0; slot < kSlotCount; ++slot) {
      if (!slots[slot]->present()) continue;
      const std::int32_t number = scene.textures[static_cast<std::size_t>(slots[slot]->texture)].image;
      if (number == scene::kNone) continue;
      const auto& image = fitted(number, device.caps().max_image_size);
      const TexelKind kind = texel_kind(slot);
      if (index_.emplace(std::pair{number, kind}, sources.size()).second) sources.push_back(image_source(image, kind));
    }
  }
  sources.push_back({{.format = VK_FORMAT_R8G8B8A8_UNORM}, std::as_bytes(std::span(kWhite))});
  images_ = make_images(device, sources);
}

Textures::Bound Textures::bound(const scene::TextureRef& ref, std::uint32_t slot) const {
  if (ref.present()) {
    const auto& texture = scene_.textures[static_cast<std::size_t>(ref.texture)];
    const auto found = index_.find({texture.image, texel_kind(slot)});
    if (found != index_.end()) return {&images_[found->second], texture.sampler};
  }
  return {&images_.back(), {}};
}

}  // namespace velarium::upload
