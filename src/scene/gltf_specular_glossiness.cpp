// KHR_materials_pbrSpecularGlossiness, which glTF has archived, in terms of what replaced it.

#include "scene/gltf_parts.hpp"

#include <cmath>

namespace velarium::scene::gltf {

namespace {

// The texture `of` once more, with roughness in its image.
std::int32_t add_roughness_texture(Context& context, std::int32_t of, float glossiness) {
  std::vector<Texture>& textures = context.scene.textures;
  textures.push_back(Texture(textures[static_cast<std::size_t>(of)]));
  context.glossiness_factors.push_back(glossiness);
  return static_cast<std::int32_t>(textures.size()) - 1;
}

}  // namespace

// A dielectric of KHR_materials_ior's index 0 has F0 = 1, which KHR_materials_specular's colour tints: F0 is the
// specular colour, and what it leaves is diffuse, as in this model. Glossiness is linear in the texture, so filtered
// roughness is that of filtered glossiness; the conversion costs half an 8-bit step and nothing else.
void read_specular_glossiness(Context& context, const Value& extension, Material& material) {
  if (material.unlit) return;
  material.base_color = extension["diffuseFactor"].clamped_vector_or(glm::vec4(1.0f), 0.0f, 1.0f);
  material.base_color_texture = read_texture_ref(context, extension["diffuseTexture"]);
  material.ior = 0.0f;
  material.specular = 1.0f;
  material.specular_texture = {};
  material.specular_color = extension["specularFactor"].clamped_vector_or(glm::vec3(1.0f), 0.0f, 1.0f);
  material.specular_color_texture = read_texture_ref(context, extension["specularGlossinessTexture"]);
  material.metallic = 0.0f;
  material.metallic_roughness_texture = material.specular_color_texture;
  const float glossiness = extension["glossinessFactor"].clamped_or(1.0f, 0.0f, 1.0f);
  const bool textured = material.metallic_roughness_texture.present();
  material.perceptual_roughness = textured ? 1.0f : 1.0f - glossiness;
  if (!textured) return;
  std::int32_t& texture = material.metallic_roughness_texture.texture;
  texture = add_roughness_texture(context, texture, glossiness);
}

void glossiness_to_roughness(float factor, std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const float glossiness = factor * static_cast<float>(rgba[i + 3]);
    rgba[i] = rgba[i + 2] = 0;
    rgba[i + 1] = static_cast<std::uint8_t>(std::lround(255.0f - glossiness));
    rgba[i + 3] = 255;
  }
}

}  // namespace velarium::scene::gltf
