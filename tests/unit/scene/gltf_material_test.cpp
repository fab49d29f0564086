#include "gltf_model.hpp"

namespace velarium::scene::test {
namespace {

// A PNG of one red pixel (RGB, 8 bits), and a header that claims 100000 x 100000 pixels; checksums hold.
constexpr unsigned char kRedPng[] = {0x89, 'P',  'N',  'G',  0x0d, 0x0a, 0x1a, 0x0a, 0,   0,    0,    13,   'I',  'H',
                                     'D',  'R',  0,    0,    0,    1,    0,    0,    0,   1,    8,    2,    0,    0,
                                     0,    0x90, 0x77, 0x53, 0xde, 0,    0,    0,    12,  'I',  'D',  'A',  'T',  0x78,
                                     0x9c, 0x63, 0xf8, 0xcf, 0xc0, 0,    0,    3,    1,   1,    0,    0xc9, 0xfe, 0x92,
                                     0xef, 0,    0,    0,    0,    'I',  'E',  'N',  'D', 0xae, 0x42, 0x60, 0x82};

std::string red_png() {
  return {reinterpret_cast<const char*>(kRedPng), sizeof kRedPng};
}

Model with_material(const char* material) {
  Model model = triangle();
  model.root["materials"] = {Json::parse(material)};
  model.primitive()["material"] = 0;
  return model;
}

Material material_of(const char* material) {
  return read(with_material(material)).materials.at(0);
}

// The triangle with this material, and one texture that shows an image given as JSON.
Model textured(const char* material, const Json& image) {
  Model model = with_material(material);
  model.root["textures"] = {{{"source", 0}}};
  model.root["images"] = {image};
  model.primitive()["attributes"]["TEXCOORD_0"] = model.add<float>("VEC2", kFloat, 3, {0, 0, 1, 0, 0, 1});
  return model;
}

constexpr const char* kShowsTexture = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})";

TEST(GltfMaterial, Defaults) {  // glTF 2.0, 5.19 and 5.22
  const Material material = material_of("{}");
  EXPECT_EQ(material.base_color, glm::vec4(1.0f));
  EXPECT_EQ(material.metallic, 1.0f);
  EXPECT_EQ(material.perceptual_roughness, 1.0f);
  EXPECT_EQ(material.emissive, glm::vec3(0.0f));
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(material.alpha_cutoff, 0.5f);
  EXPECT_FALSE(material.double_sided);
  EXPECT_FALSE(material.unlit);
  EXPECT_EQ(material.ior, 1.5f);
  EXPECT_FALSE(material.base_color_texture.present());
}

TEST(GltfMaterial, CoreProperties) {
  Model model = with_material(R"({"name": "m", "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true,
    "emissiveFactor": [1, 0.5, 0.25],
    "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.6, "roughnessFactor": 0.7,
      "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1, "texCoord": 1}},
    "normalTexture": {"index": 2, "scale": -2}, "occlusionTexture": {"index": 3, "strength": 0.8},
    "emissiveTexture": {"index": 4, "texCoord": 3}})");
  model.root["textures"] =
      Json::array({Json::object(), Json::object(), Json::object(), Json::object(), Json::object()});
  const Material m = read(model).materials.at(0);
  EXPECT_EQ(m.name, "m");
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.25f);
  EXPECT_TRUE(m.double_sided);
  EXPECT_EQ(m.emissive, glm::vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallic, 0.6f);
  EXPECT_EQ(m.perceptual_roughness, 0.7f);
  EXPECT_EQ(m.base_color_texture.texture, 0);
  EXPECT_EQ(m.metallic_roughness_texture.texture, 1);
  EXPECT_EQ(m.metallic_roughness_texture.uv_set, 1u);
  EXPECT_EQ(m.normal_texture.texture, 2);
  EXPECT_EQ(m.normal_scale, -2.0f);
  EXPECT_EQ(m.occlusion_texture.texture, 3);
  EXPECT_EQ(m.occlusion_strength, 0.8f);
  EXPECT_EQ(m.emissive_texture.texture, 4);
  EXPECT_EQ(m.emissive_texture.uv_set, 3u);
}

TEST(GltfMaterial, FactorsOutsideTheirRangeAreClampedWithAWarning) {
  const Scene scene =
      read(with_material(R"({"pbrMetallicRoughness": {"metallicFactor": 1.5, "baseColorFactor": [1, -2, 1, 1]}})"));
  EXPECT_EQ(scene.materials.at(0).metallic, 1.0f);
  EXPECT_EQ(scene.materials.at(0).base_color.y, 0.0f);
  EXPECT_TRUE(has_warning(scene, "/materials/0/pbrMetallicRoughness/metallicFactor: is 1.5, outside its range"));
  EXPECT_TRUE(has_warning(scene, "/materials/0/pbrMetallicRoughness/baseColorFactor/1: is -2"));
}

TEST(GltfMaterial, WrongOnesAreRefused) {
  expect_refused(with_material(R"({"alphaMode": "ADD"})"), "/materials/0/alphaMode: is 'ADD'");
  expect_refused(with_material(R"({"doubleSided": 1})"), "/materials/0/doubleSided: is 1, must be true or false");
  expect_refused(with_material(R"({"emissiveTexture": {}})"), "/materials/0/emissiveTexture: has no property 'index'");
  expect_refused(with_material(R"({"emissiveTexture": {"index": 0}})"),
                 "/materials/0/emissiveTexture/index: is 0, but there are 0 textures");
  Model model = with_material(R"({"emissiveTexture": {"index": 0, "texCoord": 8}})");
  model.root["textures"] = {Json::object()};
  expect_error(ErrorCode::unsupported, "/materials/0/emissiveTexture/texCoord: is 8",
               [&] { static_cast<void>(read(model)); });
}

TEST(GltfMaterial, Extensions) {
  const Material m = material_of(R"({"emissiveFactor": [1, 0.5, 0], "extensions": {
    "KHR_materials_emissive_strength": {"emissiveStrength": 8}, "KHR_materials_unlit": {},
    "KHR_materials_ior": {"ior": 1.33},
    "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [2, 1, 0]}}})");
  EXPECT_EQ(m.emissive, glm::vec3(8, 4, 0));
  EXPECT_TRUE(m.unlit);
  EXPECT_EQ(m.ior, 1.33f);
  EXPECT_EQ(m.specular, 0.5f);
  EXPECT_EQ(m.specular_color, glm::vec3(2, 1, 0));
  EXPECT_EQ(material_of(R"({"extensions": {"KHR_materials_ior": {"ior": 0}}})").ior, 0.0f);
  EXPECT_EQ(material_of(R"({"extensions": {"KHR_materials_ior": {"ior": 0.5}}})").ior, 1.0f);
  EXPECT_EQ(material_of(R"({"extensions": {"KHR_materials_ior": {}}})").ior, 1.5f);
}

TEST(GltfMaterial, SpecularTextures) {
  Model model = with_material(R"({"extensions": {"KHR_materials_specular": {"specularTexture": {"index": 0},
    "specularColorTexture": {"index": 1, "texCoord": 2}}}})");
  model.root["textures"] = Json::array({Json::object(), Json::object()});
  const Scene scene = read(model);
  EXPECT_EQ(scene.materials.at(0).specular_texture.texture, 0);
  EXPECT_EQ(scene.materials.at(0).specular_color_texture.uv_set, 2u);
  EXPECT_EQ(scene.primitives.at(0).uv[2].size(), 3u) << "missing coordinates are supplied";
  EXPECT_TRUE(has_warning(scene, "has no TEXCOORD_2, which its material asks for"));
}

TEST(GltfMaterial, TextureTransform) {
  Model model = with_material(R"({"emissiveTexture": {"index": 0, "texCoord": 1, "extensions":
    {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 1.5, "scale": [2, -1], "texCoord": 0}}},
    "occlusionTexture": {"index": 0, "texCoord": 1, "extensions": {"KHR_texture_transform": {}}}})");
  model.root["textures"] = {Json::object()};
  const Material m = read(model).materials.at(0);
  EXPECT_EQ(m.emissive_texture.offset, glm::vec2(0.5f, 0.25f));
  EXPECT_EQ(m.emissive_texture.rotation, 1.5f);
  EXPECT_EQ(m.emissive_texture.scale, glm::vec2(2, -1));
  EXPECT_EQ(m.emissive_texture.uv_set, 0u);
  EXPECT_EQ(m.occlusion_texture.offset, glm::vec2(0.0f));
  EXPECT_EQ(m.occlusion_texture.scale, glm::vec2(1.0f));
  EXPECT_EQ(m.occlusion_texture.uv_set, 1u);
}

// --- extension lists --------------------------------------------------------------------------------------------

TEST(GltfExtensions, UnsupportedOnesInUseAreNamedOnce) {
  Model model = triangle();
  model.root["extensionsUsed"] = {"KHR_xmp", "KHR_materials_unlit", "KHR_xmp"};
  const Scene scene = read(model);
  EXPECT_EQ(scene.warnings, (std::vector<std::string>{"/extensionsUsed/0: KHR_xmp is not supported; it is ignored"}));
  EXPECT_EQ(scene.extensions_used, (std::vector<std::string>{"KHR_xmp", "KHR_materials_unlit"}));
}

TEST(GltfExtensions, AllUnsupportedRequiredOnesAreNamed) {
  Model model = triangle();
  model.root["extensionsUsed"] = {"A_one", "KHR_materials_unlit", "B_two"};
  model.root["extensionsRequired"] = model.root["extensionsUsed"];
  expect_error(ErrorCode::unsupported, "requires A_one, B_two,", [&] { static_cast<void>(read(model)); });
}

TEST(GltfExtensions, UndeclaredOnesAreReadWithAWarning) {
  const Scene scene = read(with_material(R"({"extensions": {"KHR_materials_unlit": {}}})"));
  EXPECT_TRUE(scene.materials.at(0).unlit);
  EXPECT_TRUE(has_warning(scene, "/materials/0/extensions/KHR_materials_unlit: is not listed in /extensionsUsed"));
}

// --- textures and images ----------------------------------------------------------------------------------------

Sampler sampler_of(const char* sampler) {
  Model model = triangle();
  model.root["samplers"] = {Json::parse(sampler)};
  model.root["textures"] = {{{"sampler", 0}}};
  return read(model).textures.at(0).sampler;
}

TEST(GltfTexture, Samplers) {
  EXPECT_EQ(sampler_of("{}"), Sampler());
  const Sampler s = sampler_of(R"({"magFilter": 9728, "minFilter": 9986, "wrapS": 33071, "wrapT": 33648})");
  EXPECT_EQ(s.mag, Filter::nearest);
  EXPECT_EQ(s.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(s.wrap_v, Wrap::mirrored_repeat);
  struct Row {
    int value;
    Filter min, mip;
    bool mipmapped;
  };
  const Row rows[] = {{9728, Filter::nearest, Filter::nearest, false}, {9729, Filter::linear, Filter::nearest, false},
                      {9984, Filter::nearest, Filter::nearest, true},  {9985, Filter::linear, Filter::nearest, true},
                      {9986, Filter::nearest, Filter::linear, true},   {9987, Filter::linear, Filter::linear, true}};
  for (const Row& row : rows) {
    const Sampler read = sampler_of(("{\"minFilter\": " + std::to_string(row.value) + "}").c_str());
    EXPECT_EQ(read.min, row.min) << row.value;
    EXPECT_EQ(read.mipmapped, row.mipmapped) << row.value;
    if (row.mipmapped) { EXPECT_EQ(read.mip, row.mip) << row.value; }
  }
}

TEST(GltfTexture, WrongOnesAreRefused) {
  const auto refuse = [](const char* key, const Json& value, const std::string& part) {
    Model model = triangle();
    model.root["samplers"] = {{{key, value}}};
    expect_refused(model, "/samplers/0/" + part);
  };
  refuse("wrapS", 1, "wrapS: ");
  refuse("wrapT", "repeat", "wrapT: ");
  refuse("magFilter", 9984, "magFilter: ");
  refuse("minFilter", 9988, "minFilter: ");
  Model model = triangle();
  model.root["textures"] = {{{"sampler", 0}}};
  expect_refused(model, "/textures/0/sampler: is 0, but there are 0 samplers");
  model.root["textures"] = {{{"source", 0}}};
  expect_refused(model, "/textures/0/source: is 0, but there are 0 images");
}

void expect_red(const Scene& scene) {
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.textures.at(0).image, 0);
  EXPECT_EQ(scene.images[0].width, 1u);
  EXPECT_EQ(scene.images[0].rgba, (std::vector<std::uint8_t>{255, 0, 0, 255}));
}

TEST(GltfImage, FromDataFileAndView) {
  // The declared type is not believed: content decides.
  expect_red(read(textured(kShowsTexture, {{"uri", "data:image/jpeg;base64," + base64(red_png())}})));
  Model embedded = textured(kShowsTexture, {{"mimeType", "image/png"}});
  embedded.root["images"][0]["bufferView"] = embedded.add_view(red_png());
  expect_red(read(embedded));
  const TemporaryFolder folder;
  folder.write("red one.png", red_png());
  const auto file = folder.write("model.gltf", textured(kShowsTexture, {{"uri", "red%20one.png"}}).text());
  expect_red(read_gltf(file));
}

TEST(GltfImage, OnlyThoseInUseAreDecodedEachOnce) {
  const Json good = {{"uri", "data:;base64," + base64(red_png())}, {"name", "red"}};
  const Json bad = {{"uri", "absent.png"}};
  Model model =
      textured(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}, "emissiveTexture": {"index": 2}})", bad);
  model.root["images"] = {bad, good};
  model.root["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 1}}};
  model.root["materials"].push_back({{"emissiveTexture", {{"index", 0}}}});  // no primitive has this material
  const Scene scene = read(model);
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].name, "red");
  EXPECT_EQ(scene.textures.at(0).image, kNone);
  EXPECT_EQ(scene.textures.at(1).image, 0);
  EXPECT_EQ(scene.textures.at(2).image, 0);
}

TEST(GltfImage, OfOtherScenesAreNotDecoded) {
  Model model = textured(kShowsTexture, {{"uri", "absent.png"}});
  model.root["scenes"].push_back({{"nodes", Json::array()}});
  model.root["scene"] = 1;
  EXPECT_TRUE(read(model).images.empty());
}

TEST(GltfImage, WrongOnesAreRefused) {
  expect_refused(textured(kShowsTexture, Json::object()), "/images/0: must have either uri or bufferView");
  expect_refused(textured(kShowsTexture, {{"bufferView", 99}}), "/images/0/bufferView: is 99");
  expect_refused(textured(kShowsTexture, {{"uri", "data:,text"}}), "/images/0: ");
  expect_refused(textured(kShowsTexture, {{"uri", "data:;base64," + base64(red_png().substr(0, 40))}}), "/images/0: ");
  expect_refused(textured(kShowsTexture, {{"uri", "https://example.org/a.png"}}), "/images/0/uri: has a scheme");
}

TEST(GltfImage, AMissingFileLeavesTheFactor) {
  Model model = textured(kShowsTexture, {{"uri", "absent.png"}});
  GltfOptions strict;
  strict.strict = true;
  expect_error(ErrorCode::input_missing, "/images/0/uri: 'absent.png' does not exist",
               [&] { static_cast<void>(read(model, strict)); });
  const Scene scene = read(model);
  EXPECT_TRUE(has_warning(scene, "'absent.png' does not exist; baseColorTexture of /materials/0 is left out"));
  EXPECT_FALSE(scene.materials.at(0).base_color_texture.present());
  model.root["materials"][0]["normalTexture"] = {{"index", 0}};
  const Scene bumpy = read(model);
  EXPECT_TRUE(has_warning(bumpy, "baseColorTexture of /materials/0 and 1 more is left out"));
  EXPECT_FALSE(bumpy.materials.at(0).normal_texture.present());
}

// As other systems and servers spell them.
TEST(GltfImage, FilesUnderAnotherSpelling) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "Textures");
  folder.write("Textures/Red.png", red_png());
  for (const char* uri : {"textures/red.PNG", "Textures\\Red.png", "textures%5CRed.png", "Textures/Red.png?v=2#top"}) {
    const auto file = folder.write("model.gltf", textured(kShowsTexture, {{"uri", uri}}).text());
    const Scene scene = read_gltf(file);
    expect_red(scene);
    EXPECT_TRUE(has_warning(scene, "does not exist; 'Textures/Red.png' was read")) << uri;
    EXPECT_THROW(static_cast<void>(read_gltf(file, {.strict = true})), Error) << uri;
  }
  // Another spelling leads out of the folder no more than the first.
  const auto file =
      folder.write("Textures/model.gltf", textured(kShowsTexture, {{"uri", "..\\textures\\red.png"}}).text());
  EXPECT_THROW(static_cast<void>(read_gltf(file)), Error);
}

TEST(GltfImage, SchemesIgnoreCase) {
  expect_red(read(textured(kShowsTexture, {{"uri", "DATA:image/png;BASE64," + base64(red_png())}})));
}

TEST(GltfImage, SizesAreBoundedBeforeDecoding) {
  std::string huge = red_png();
  huge.replace(16, 8, std::string("\0\x01\x86\xa0\0\x01\x86\xa0", 8));  // 100000 x 100000
  const Model huge_model = textured(kShowsTexture, {{"uri", "data:;base64," + base64(huge)}});
  expect_refused(huge_model,
                 "/images/0: is 100000 x 100000: a side of 100000 pixels, more than load.image_size=32768 allows; "
                 "load.image_size cannot be more than 32768");
  GltfOptions options;
  options.limits.image_size = 100'000;
  options.limits.pixels = 1'000'000;
  expect_refused(huge_model,
                 "/images/0: is 100000 x 100000: with it, the scene shows 10000000000 pixels, more than "
                 "load.pixels=1000000 allows; -D load.pixels=10000000000 allows it",
                 options);
}

TEST(GltfImage, ATextureWithoutOneIsWhiteWithAWarning) {
  Model model = textured(kShowsTexture, {{"uri", "absent.png"}});
  model.root["textures"][0].erase("source");
  const Scene scene = read(model);
  EXPECT_EQ(scene.textures.at(0).image, kNone);
  EXPECT_TRUE(has_warning(scene, "/textures/0: has no image"));
}

}  // namespace
}  // namespace velarium::scene::test
