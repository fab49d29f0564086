#include "scene/description_parts.hpp"
#include "scene/description_place.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace velarium::scene::description {
namespace {

constexpr std::uint32_t kLargestSide = 16384;  // as files may have it by default (load.image_size)

Wrap wrap_of(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::repeat:
      return Wrap::repeat;
    case TextureWrap::mirrored_repeat:
      return Wrap::mirrored_repeat;
    case TextureWrap::clamp_to_edge:
      return Wrap::clamp_to_edge;
  }
  return Wrap::repeat;
}

scene::AlphaMode alpha_mode_of(velarium::AlphaMode mode) {
  switch (mode) {
    case velarium::AlphaMode::opaque:
      return AlphaMode::opaque;
    case velarium::AlphaMode::mask:
      return AlphaMode::mask;
    case velarium::AlphaMode::blend:
      return AlphaMode::blend;
  }
  return AlphaMode::opaque;
}

// Equal uses of an image are one texture, so that it lies on the device once.
std::int32_t texture_of(const Texture& wanted, std::vector<Texture>& textures) {
  const auto found = std::ranges::find_if(
      textures, [&](const Texture& t) { return t.image == wanted.image && t.sampler == wanted.sampler; });
  if (found == textures.end()) {
    textures.push_back(wanted);
    return static_cast<std::int32_t>(textures.size() - 1);
  }
  return static_cast<std::int32_t>(found - textures.begin());
}

TextureRef texture_ref(const Place& at, std::string_view member, const TextureDescription& description, Scene& scene) {
  TextureRef ref;
  Texture texture;
  texture.image = at.reference(fmt::format("{}.image", member), description.image, scene.images.size(), "images");
  if (texture.image == kNone) return ref;
  texture.sampler.wrap_u = wrap_of(description.wrap_u);
  texture.sampler.wrap_v = wrap_of(description.wrap_v);
  if (description.filter == TextureFilter::nearest) texture.sampler.mag = Filter::nearest;
  ref.texture = texture_of(texture, scene.textures);
  return ref;
}

void check_factors(const Place& at, const MaterialDescription& material) {
  at.between("base_color", material.base_color, 0.0f, 1.0f);
  at.between("metallic", material.metallic, 0.0f, 1.0f);
  at.between("perceptual_roughness", material.perceptual_roughness, 0.0f, 1.0f);
  at.finite("normal_scale", material.normal_scale);
  at.between("occlusion_strength", material.occlusion_strength, 0.0f, 1.0f);
  at.not_negative("emissive", material.emissive);
  at.not_negative("ior", material.ior);
  if (material.ior > 0.0f && material.ior < 1.0f)
    at.fail("ior", fmt::format("is {}, must be 0 or at least 1", material.ior));
  at.between("specular", material.specular, 0.0f, 1.0f);
  at.not_negative("specular_color", material.specular_color);
  at.not_negative("alpha_cutoff", material.alpha_cutoff);
}

Material material_of(const Place& at, const MaterialDescription& from, Scene& scene) {
  check_factors(at, from);
  const auto ref = [&](std::string_view member, const TextureDescription& texture) {
    return texture_ref(at, member, texture, scene);
  };
  Material material;
  material.name = from.name;
  material.base_color = {from.base_color[0], from.base_color[1], from.base_color[2], from.base_color[3]};
  material.base_color_texture = ref("base_color_texture", from.base_color_texture);
  material.metallic = from.metallic;
  material.perceptual_roughness = from.perceptual_roughness;
  material.metallic_roughness_texture = ref("metallic_roughness_texture", from.metallic_roughness_texture);
  material.normal_scale = from.normal_scale;
  material.normal_texture = ref("normal_texture", from.normal_texture);
  material.occlusion_strength = from.occlusion_strength;
  material.occlusion_texture = ref("occlusion_texture", from.occlusion_texture);
  material.emissive = {from.emissive[0], from.emissive[1], from.emissive[2]};
  material.emissive_texture = ref("emissive_texture", from.emissive_texture);
  material.ior = from.ior;
  material.specular = from.specular;
  material.specular_color = {from.specular_color[0], from.specular_color[1], from.specular_color[2]};
  material.specular_texture = ref("specular_texture", from.specular_texture);
  material.specular_color_texture = ref("specular_color_texture", from.specular_color_texture);
  material.alpha_mode = alpha_mode_of(from.alpha_mode);
  material.alpha_cutoff = from.alpha_cutoff;
  material.double_sided = from.double_sided;
  material.unlit = from.unlit;
  return material;
}

}  // namespace

void add_images(const SceneDescription& description, Scene& scene) {
  for (const ImageDescription& image : description.images) {
    const Place at("images", scene.images.size());
    for (const auto& [member, side] : {std::pair("width", image.width), std::pair("height", image.height)})
      if (side < 1 || side > kLargestSide)
        at.fail(member, fmt::format("is {}, must be from 1 to {}", side, kLargestSide));
    const std::size_t size = std::size_t{4} * image.width * image.height;
    if (image.rgba.size() != size) {
      at.fail("rgba", fmt::format("has {} values, but {} x {} pixels have {}", image.rgba.size(), image.width,
                                  image.height, size));
    }
    scene.images.push_back({image.name, image.width, image.height, image.rgba});
  }
}

void add_materials(const SceneDescription& description, Scene& scene) {
  for (const MaterialDescription& material : description.materials)
    scene.materials.push_back(material_of(Place("materials", scene.materials.size()), material, scene));
}

}  // namespace velarium::scene::description
