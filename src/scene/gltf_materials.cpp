#include "scene/gltf_parts.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace velarium::scene::gltf {

namespace {

constexpr float kAnyPositive = std::numeric_limits<float>::max();

// glTF 2.0, 3.8.4: the constants are OpenGL's.
constexpr std::uint64_t kNearest = 9728, kLinear = 9729, kNearestMipNearest = 9984, kLinearMipNearest = 9985,
                        kNearestMipLinear = 9986, kLinearMipLinear = 9987;
constexpr std::uint64_t kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497;

Wrap read_wrap(const Value& value) {
  switch (value.integer_or(kRepeat, 0, UINT16_MAX)) {
    case kRepeat:
      return Wrap::repeat;
    case kMirroredRepeat:
      return Wrap::mirrored_repeat;
    case kClampToEdge:
      return Wrap::clamp_to_edge;
    default:
      value.fail("must be 10497 (repeat), 33648 (mirrored repeat) or 33071 (clamp to edge)");
  }
}

Filter read_mag_filter(const Value& value) {
  switch (value.integer_or(kLinear, 0, UINT16_MAX)) {
    case kNearest:
      return Filter::nearest;
    case kLinear:
      return Filter::linear;
    default:
      value.fail("must be 9728 (nearest) or 9729 (linear)");
  }
}

void read_min_filter(const Value& value, Sampler& sampler) {
  const auto set = [&](Filter min, Filter mip, bool mipmapped) {
    sampler.min = min;
    sampler.mip = mip;
    sampler.mipmapped = mipmapped;
  };
  switch (value.integer_or(kLinearMipLinear, 0, UINT16_MAX)) {
    case kNearest:
      return set(Filter::nearest, Filter::nearest, false);
    case kLinear:
      return set(Filter::linear, Filter::nearest, false);
    case kNearestMipNearest:
      return set(Filter::nearest, Filter::nearest, true);
    case kLinearMipNearest:
      return set(Filter::linear, Filter::nearest, true);
    case kNearestMipLinear:
      return set(Filter::nearest, Filter::linear, true);
    case kLinearMipLinear:
      return set(Filter::linear, Filter::linear, true);
    default:
      value.fail("must be 9728, 9729 or 9984 to 9987");
  }
}

Sampler read_sampler(const Value& value) {
  Sampler sampler;
  sampler.wrap_u = read_wrap(value["wrapS"]);
  sampler.wrap_v = read_wrap(value["wrapT"]);
  sampler.mag = read_mag_filter(value["magFilter"]);
  read_min_filter(value["minFilter"], sampler);
  return sampler;
}

std::uint32_t read_uv_set(const Value& value) {
  const std::uint64_t set = value.integer_or(0, 0, UINT32_MAX);
  if (set >= kMaxUvSets) {
    throw Error(ErrorCode::unsupported, value.file(),
                fmt::format("{}: is {}, but only the first {} sets of texture coordinates are supported",
                            value.pointer(), set, kMaxUvSets));
  }
  return static_cast<std::uint32_t>(set);
}

AlphaMode read_alpha_mode(const Value& value) {
  const std::string mode = value.text_or("OPAQUE");
  if (mode == "OPAQUE") return AlphaMode::opaque;
  if (mode == "MASK") return AlphaMode::mask;
  if (mode == "BLEND") return AlphaMode::blend;
  value.fail(fmt::format("is '{}', must be OPAQUE, MASK or BLEND", mode));
}

Material read_material(Context& context, const Value& value) {
  Material material;
  material.name = value["name"].text_or("");
  const Value pbr = value["pbrMetallicRoughness"];
  material.base_color = pbr["baseColorFactor"].clamped_vector_or(material.base_color, 0.0f, 1.0f);
  material.base_color_texture = read_texture_ref(context, pbr["baseColorTexture"]);
  material.metallic = pbr["metallicFactor"].clamped_or(material.metallic, 0.0f, 1.0f);
  material.perceptual_roughness = pbr["roughnessFactor"].clamped_or(material.perceptual_roughness, 0.0f, 1.0f);
  material.metallic_roughness_texture = read_texture_ref(context, pbr["metallicRoughnessTexture"]);
  const Value normal = value["normalTexture"];
  material.normal_texture = read_texture_ref(context, normal);
  material.normal_scale = normal["scale"].number_or(material.normal_scale);
  const Value occlusion = value["occlusionTexture"];
  material.occlusion_texture = read_texture_ref(context, occlusion);
  material.occlusion_strength = occlusion["strength"].clamped_or(material.occlusion_strength, 0.0f, 1.0f);
  material.emissive = value["emissiveFactor"].clamped_vector_or(material.emissive, 0.0f, 1.0f);
  material.emissive_texture = read_texture_ref(context, value["emissiveTexture"]);
  material.alpha_mode = read_alpha_mode(value["alphaMode"]);
  material.alpha_cutoff = value["alphaCutoff"].clamped_or(material.alpha_cutoff, 0.0f, kAnyPositive);
  material.double_sided = value["doubleSided"].boolean_or(material.double_sided);
  read_extensions(context, value, &Extension::material, material);
  return material;
}

}  // namespace

void read_textures(Context& context) {
  std::vector<Sampler> samplers;
  for (const Value& value : context.root["samplers"].elements()) samplers.push_back(read_sampler(value));
  const std::uint32_t image_count = context.root["images"].size();
  for (const Value& value : context.root["textures"].elements()) {
    Texture& texture = context.scene.textures.emplace_back();
    const auto sampler = value["sampler"].reference_or_none(static_cast<std::uint32_t>(samplers.size()), "samplers");
    if (sampler != kNone) texture.sampler = samplers[static_cast<std::size_t>(sampler)];
    texture.image = value["source"].reference_or_none(image_count, "images");
    read_extensions(context, value, &Extension::texture, texture);
  }
}

TextureRef read_texture_ref(Context& context, const Value& value) {
  TextureRef ref;
  if (!value) return ref;
  const std::uint32_t count = context.root["textures"].size();  // ours, which follow, are out of the file's reach
  ref.texture = static_cast<std::int32_t>(value.require("index").reference(count, "textures"));
  ref.uv_set = read_uv_set(value["texCoord"]);
  read_extensions(context, value, &Extension::texture_ref, ref);
  return ref;
}

std::array<const TextureRef*, 7> texture_refs(const Material& material) {
  return {&material.base_color_texture,    &material.metallic_roughness_texture, &material.normal_texture,
          &material.occlusion_texture,     &material.emissive_texture,           &material.specular_texture,
          &material.specular_color_texture};
}

std::array<TextureRef*, 7> texture_refs(Material& material) {
  std::array<TextureRef*, 7> refs{};
  std::ranges::transform(texture_refs(std::as_const(material)), refs.begin(),
                         [](const TextureRef* ref) { return const_cast<TextureRef*>(ref); });
  return refs;
}

void read_materials(Context& context) {
  for (const Value& value : context.root["materials"].elements()) {
    context.scene.materials.push_back(read_material(context, value));
  }
}

// The image of `source` beside it is for readers that have no WebP.
void read_webp_source(Context& context, const Value& extension, Texture& texture) {
  const Value source = extension["source"];
  if (source) texture.image = source.reference_or_none(context.root["images"].size(), "images");
}

void read_texture_transform(Context&, const Value& extension, TextureRef& ref) {
  ref.offset = extension["offset"].vector_or(ref.offset);
  ref.rotation = extension["rotation"].number_or(ref.rotation);
  ref.scale = extension["scale"].vector_or(ref.scale);
  if (const Value uv_set = extension["texCoord"]) ref.uv_set = read_uv_set(uv_set);
}

void read_unlit(Context&, const Value&, Material& material) {
  material.unlit = true;
}

void read_emissive_strength(Context&, const Value& extension, Material& material) {
  material.emissive *= extension["emissiveStrength"].clamped_or(1.0f, 0.0f, kAnyPositive);
}

void read_ior(Context&, const Value& extension, Material& material) {
  const Value ior = extension["ior"];
  if (ior && ior.number() == 0.0f) {
    material.ior = 0.0f;  // the extension's way to say that Fresnel reflection is total
  } else {
    material.ior = ior.clamped_or(material.ior, 1.0f, kAnyPositive);
  }
}

void read_specular(Context& context, const Value& extension, Material& material) {
  material.specular = extension["specularFactor"].clamped_or(material.specular, 0.0f, 1.0f);
  material.specular_texture = read_texture_ref(context, extension["specularTexture"]);
  material.specular_color =
      extension["specularColorFactor"].clamped_vector_or(material.specular_color, 0.0f, kAnyPositive);
  material.specular_color_texture = read_texture_ref(context, extension["specularColorTexture"]);
}

}  // namespace velarium::scene::gltf
