// KHR_materials_variants and EXT_texture_webp.

#include "gltf_model.hpp"
#include "image/image.hpp"

namespace velarium::scene::test {
namespace {

// Two shoes' materials, named twice and thrice; the primitive usually has material 0.
Model with_variants() {
  Model model = triangle();
  model.root["extensionsUsed"] = {"KHR_materials_variants"};
  model.root["extensions"]["KHR_materials_variants"] =
      Json::parse(R"({"variants": [{"name": "red"}, {"name": "blue"}, {"name": "2"}, {"name": "grey"}]})");
  model.root["materials"] = Json::parse(R"([{"name": "a"}, {"name": "b"}, {"name": "c"}])");
  model.primitive()["material"] = 0;
  model.primitive()["extensions"]["KHR_materials_variants"] =
      Json::parse(R"({"mappings": [{"material": 1, "variants": [0, 2]}, {"material": 2, "variants": [1]}]})");
  return model;
}

std::int32_t material_in(const std::string& variant) {
  return read(with_variants(), {.variant = variant}).primitives.at(0).material;
}

Json& mappings(Model& model) {
  return model.primitive()["extensions"]["KHR_materials_variants"]["mappings"];
}

TEST(GltfVariants, AreListed) {
  EXPECT_EQ(read(with_variants()).variants, (std::vector<std::string>{"red", "blue", "2", "grey"}));
}

TEST(GltfVariants, ChooseTheMaterial) {
  EXPECT_EQ(material_in(""), 0);
  EXPECT_EQ(material_in("none"), 0);
  EXPECT_EQ(material_in("red"), 1);
  EXPECT_EQ(material_in("blue"), 2);
  EXPECT_EQ(material_in("1"), 2) << "an index";
  EXPECT_EQ(material_in("2"), 1) << "a name goes before an index";
  EXPECT_EQ(material_in("grey"), 0) << "a variant without a mapping keeps the usual material";
}

TEST(GltfVariants, UnknownOnesAreAUsageErrorThatListsThem) {
  expect_error(ErrorCode::usage, R"(no variant "green"; there are: 0 "red", 1 "blue", 2 "2", 3 "grey", none)",
               [] { static_cast<void>(material_in("green")); });
  expect_error(ErrorCode::usage, R"(no variant "red"; there are: none)",
               [] { static_cast<void>(read(triangle(), {.variant = "red"})); });
}

TEST(GltfVariants, MappingsAreChecked) {
  const std::string place = "/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings";
  Model model = with_variants();
  mappings(model)[0]["material"] = 3;
  expect_refused(model, place + "/0/material: ");
  model = with_variants();
  mappings(model)[0]["variants"][1] = 4;
  expect_refused(model, place + "/0/variants/1: ");
  model = with_variants();
  mappings(model)[1]["variants"][0] = 2;
  expect_refused(model, place + "/1/variants/0: variant 2 has a material already");
  model = with_variants();
  mappings(model)[0].erase("variants");
  expect_refused(model, place + "/0: ");
}

TEST(GltfWebp, GoesBeforeTheImageForOtherReaders) {
  const TemporaryFolder folder;
  image::save_webp(folder.path() / "blue.webp", {1, 1, {0, 0, 255, 255}}, 100);
  Model model = triangle();
  model.root["extensionsUsed"] = {"EXT_texture_webp"};
  model.root["images"] = Json::parse(R"([{"uri": "missing.png"}, {"uri": "blue.webp", "mimeType": "image/webp"}])");
  model.root["textures"] = Json::parse(R"([{"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}])");
  model.root["materials"] = Json::parse(R"([{"emissiveTexture": {"index": 0}}])");
  model.primitive()["material"] = 0;
  const Scene scene = read_gltf(folder.write("model.gltf", model.text()));
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].rgba, (std::vector<std::uint8_t>{0, 0, 255, 255}));
  model.root["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 2;
  expect_refused(model, "/textures/0/extensions/EXT_texture_webp/source: ");
}

}  // namespace
}  // namespace velarium::scene::test
