// KHR_materials_pbrSpecularGlossiness, converted.

#include "gltf_model.hpp"
#include "image/image.hpp"

namespace velarium::scene::test {
namespace {

constexpr const char* kName = "KHR_materials_pbrSpecularGlossiness";

Model with_material(const char* extension) {
  Model model = triangle();
  model.root["extensionsUsed"] = {kName};
  model.root["materials"] = Json::parse(R"([{"pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 1]}}])");
  model.root["materials"][0]["extensions"][kName] = Json::parse(extension);
  model.primitive()["material"] = 0;
  return model;
}

Material material_of(const char* extension) {
  return read(with_material(extension)).materials.at(0);
}

TEST(GltfSpecularGlossiness, FactorsBecomeThoseOfADielectricOfFullReflectance) {
  const Material m = material_of(R"({"diffuseFactor": [0.1, 0.2, 0.3, 0.4], "specularFactor": [0.5, 0.6, 0.7],
                                     "glossinessFactor": 0.25})");
  EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.specular_color, glm::vec3(0.5f, 0.6f, 0.7f));
  EXPECT_EQ(m.ior, 0.0f);
  EXPECT_EQ(m.metallic, 0.0f);
  EXPECT_EQ(m.perceptual_roughness, 0.75f);
}

TEST(GltfSpecularGlossiness, Defaults) {  // of the extension: all 1
  const Material m = material_of("{}");
  EXPECT_EQ(m.base_color, glm::vec4(1.0f));
  EXPECT_EQ(m.specular_color, glm::vec3(1.0f));
  EXPECT_EQ(m.perceptual_roughness, 0.0f);
}

TEST(GltfSpecularGlossiness, GlossinessInATextureBecomesRoughness) {
  const TemporaryFolder folder;
  image::save_png(folder.path() / "sg.png", image::ByteImage{3, 1, {10, 20, 30, 0, 40, 50, 60, 128, 70, 80, 90, 255}});
  Model model = with_material(
      R"({"specularGlossinessTexture": {"index": 0, "texCoord": 1}, "diffuseTexture": {"index": 0},
          "glossinessFactor": 0.5})");
  model.root["materials"].push_back(model.root["materials"][0]);  // the picture is made once for both
  model.root["meshes"][0]["primitives"].push_back(model.primitive());
  model.root["meshes"][0]["primitives"][1]["material"] = 1;
  model.root["images"] = {{{"uri", "sg.png"}}};
  model.root["textures"] = {{{"source", 0}}};
  const Scene scene = read_gltf(folder.write("model.gltf", model.text()));
  const Material& m = scene.materials.at(0);
  EXPECT_EQ(m.base_color_texture.texture, 0);
  EXPECT_EQ(m.specular_color_texture.texture, 0);
  EXPECT_EQ(m.specular_color_texture.uv_set, 1u);
  EXPECT_EQ(m.metallic_roughness_texture.uv_set, 1u);
  EXPECT_EQ(m.perceptual_roughness, 1.0f);
  ASSERT_EQ(scene.images.size(), 2u);
  const Texture& texture = scene.textures.at(static_cast<std::size_t>(m.metallic_roughness_texture.texture));
  const std::vector<std::uint8_t>& rough = scene.images.at(static_cast<std::size_t>(texture.image)).rgba;
  // 255 (1 - 0.5 a / 255): 255, 191, and 127.5 rounded up.
  EXPECT_EQ(rough, (std::vector<std::uint8_t>{0, 255, 0, 255, 0, 191, 0, 255, 0, 128, 0, 255}));
  EXPECT_EQ(scene.images[static_cast<std::size_t>(scene.textures[0].image)].rgba[7], 128) << "the file's is kept";
}

// The textures that are made stand after the file's in one table.
TEST(GltfSpecularGlossiness, FilesCannotReferToMadeTextures) {
  Model model = with_material(R"({"specularGlossinessTexture": {"index": 0}})");
  model.root["textures"] = {Json::object()};
  model.root["materials"].push_back(Json::parse(R"({"emissiveTexture": {"index": 1}})"));
  expect_refused(model, "/materials/1/emissiveTexture/index: ");
}

TEST(GltfSpecularGlossiness, UnlitGoesBefore) {
  Model model = with_material(R"({"diffuseFactor": [1, 0, 0, 1]})");
  model.root["materials"][0]["extensions"]["KHR_materials_unlit"] = Json::object();
  EXPECT_EQ(read(model).materials.at(0).base_color, glm::vec4(0, 1, 0, 1));
}

}  // namespace
}  // namespace velarium::scene::test
