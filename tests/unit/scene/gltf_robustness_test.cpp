// Hostile and real files: damaged on purpose here, and, where VELARIUM_ASSETS names a folder of them, collected ones.

#include "gltf_model.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

namespace velarium::scene::test {
namespace {

namespace fs = std::filesystem;

void add_extensions(Model& model) {
  model.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing", "EXT_texture_webp", "KHR_materials_pbrSpecularGlossiness",
                                  "KHR_materials_variants"};
  model.root["extensions"]["KHR_materials_variants"]["variants"] = Json::parse(R"([{"name": "a"}, {"name": "b"}])");
  model.primitive()["extensions"]["KHR_materials_variants"]["mappings"] =
      Json::parse(R"([{"material": 1, "variants": [0, 1]}])");
  model.root["materials"].push_back(Json::parse(R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {
    "diffuseFactor": [1, 1, 1, 1], "glossinessFactor": 0.5, "specularGlossinessTexture": {"index": 0}}}})"));
  model.root["textures"][0]["extensions"]["EXT_texture_webp"] = Json::object();
  Json node = {{"mesh", 0}};
  const int places = model.add<float>("VEC3", kFloat, 2, {0, 0, 0, 1, 1, 1});
  const int turns = model.add<std::int8_t>("VEC4", kByte, 2, {0, 0, 0, 127, 0, 0, 127, 0}, true);
  node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", places}, {"ROTATION", turns}};
  model.root["nodes"].push_back(node);
  model.root["scenes"][0]["nodes"].push_back(2);
}

// A model that uses most features, so that damage reaches most of the reader.
std::string rich_model() {
  Model model = triangle();
  Json& attributes = model.primitive()["attributes"];
  attributes["TEXCOORD_0"] = model.add<float>("VEC2", kFloat, 3, {0, 0, 1, 0, 0, 1});
  attributes["JOINTS_0"] = model.add<std::uint8_t>("VEC4", kUnsignedByte, 3, std::vector<std::uint8_t>(12, 0));
  attributes["WEIGHTS_0"] = model.add<float>("VEC4", kFloat, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  model.primitive()["indices"] = model.add<std::uint16_t>("SCALAR", kUnsignedShort, 3, {0, 1, 2});
  model.primitive()["targets"] = {{{"POSITION", 0}}};
  model.primitive()["material"] = 0;
  model.root["textures"] = {{{"sampler", 0}}};
  model.root["samplers"] = {{{"wrapS", 33071}}};
  model.root["materials"] = {{{"normalTexture", {{"index", 0}}}, {"alphaMode", "MASK"}}};
  model.root["nodes"] = Json::parse(R"([{"mesh": 0, "skin": 0, "children": [1]}, {"rotation": [0, 0, 0, 1]}])");
  model.root["skins"] = {{{"joints", {1}}}};
  model.root["cameras"] = {Json::parse(R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}})")};
  const int times = model.add<float>("SCALAR", kFloat, 2, {0, 1});
  const int values = model.add<float>("VEC3", kFloat, 2, {0, 0, 0, 1, 1, 1});
  const int index_view = model.add_view(bytes_of<std::uint8_t>({1}));
  const int value_view = model.add_view(bytes_of<float>({2, 2, 2}));
  model.root["accessors"][0]["sparse"] = {{"count", 1},
                                          {"indices", {{"bufferView", index_view}, {"componentType", kUnsignedByte}}},
                                          {"values", {{"bufferView", value_view}}}};
  add_extensions(model);
  model.root["animations"] = {{{"samplers", {{{"input", times}, {"output", values}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "scale"}}}}}}}};
  return model.text();
}

// Whatever the file, the reader returns or throws Error. Limits keep an unlucky number from taking minutes.
void expect_orderly(const fs::path& file) {
  GltfOptions options;
  options.limits.elements = 1 << 20;
  options.variant = "1";
  try {
    static_cast<void>(read_gltf(file, options));
  } catch (const Error& error) { EXPECT_NE(error.code(), ErrorCode::internal) << error.what(); }
}

TEST(GltfRobustness, TheRichModelReads) {
  EXPECT_TRUE(read_text(rich_model()).warnings.size() <= 1u);
}

TEST(GltfRobustness, DamagedBytesAreReadOrRefused) {
  const TemporaryFolder folder;
  const std::string whole = rich_model();
  std::mt19937 random(1);
  constexpr std::string_view kLikely = "0123456789-.eE\"[]{},:\\ntf\xff";
  for (int round = 0; round < 4000; ++round) {
    std::string damaged = whole;
    for (std::uint32_t i = random() % 3 + 1; i > 0; --i) {
      damaged[random() % damaged.size()] = kLikely[random() % kLikely.size()];
    }
    expect_orderly(folder.write("damaged.gltf", damaged));
  }
}

// Replaces each value of the document in turn by values of every type and of unlikely size.
void damage_values(const Json& whole, Json& document, Json& at, const TemporaryFolder& folder) {
  for (auto it = at.begin(); at.is_structured() && it != at.end(); ++it) damage_values(whole, document, *it, folder);
  const Json original = at;
  for (const Json& wrong :
       {Json(-1), Json(0), Json(1), Json(3.5), Json(4294967295u), Json(18446744073709551615u), Json(1e308), Json("x"),
        Json(true), Json(nullptr), Json(Json::array()), Json(Json::object()), Json(Json::array({0, 0}))}) {
    at = wrong;
    expect_orderly(folder.write("damaged.gltf", document.dump()));
  }
  at = original;
}

TEST(GltfRobustness, WrongValuesAreReadOrRefused) {
  const TemporaryFolder folder;
  const Json whole = Json::parse(rich_model());
  Json document = whole;
  damage_values(whole, document, document, folder);
  EXPECT_EQ(document, whole);
}

TEST(GltfRobustness, DamagedDataIsReadOrRefused) {
  const TemporaryFolder folder;
  Json document = Json::parse(rich_model());
  const std::size_t size = document["buffers"][0]["byteLength"];
  std::mt19937 random(2);
  for (int round = 0; round < 500; ++round) {
    std::string data(size, '\0');
    for (char& byte : data) byte = static_cast<char>(random());
    document["buffers"][0]["uri"] = "data:;base64," + base64(data);
    expect_orderly(folder.write("damaged.gltf", document.dump()));
  }
}

// --- collected files --------------------------------------------------------------------------------------------

class GltfAssets : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("VELARIUM_ASSETS");
    if (!folder) GTEST_SKIP() << "VELARIUM_ASSETS is not set";
    root_ = folder;
  }

  [[nodiscard]] std::vector<fs::path> files(const char* subfolder) const {
    std::vector<fs::path> found;
    if (!fs::exists(root_ / subfolder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(root_ / subfolder)) {
      const std::string extension = entry.path().extension();
      if (extension == ".gltf" || extension == ".glb") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  fs::path root_;
};

// What scene.hpp promises to those who read its tables.
void expect_sound(const Scene& scene) {
  for (const Primitive& primitive : scene.primitives) {
    const std::size_t vertices = primitive.vertex_count();
    EXPECT_FALSE(primitive.indices.empty());
    EXPECT_LT(*std::max_element(primitive.indices.begin(), primitive.indices.end()), vertices);
    EXPECT_FALSE(primitive.bounds.empty());
    EXPECT_EQ(primitive.joints.size(), primitive.skin_sets * vertices);
    if (primitive.topology == Topology::triangles) { EXPECT_EQ(primitive.vertices.normals.size(), vertices); }
    for (const auto& uv : primitive.uv) EXPECT_TRUE(uv.empty() || uv.size() == vertices);
    EXPECT_TRUE(primitive.colors.empty() || primitive.colors.size() == vertices);
    for (const MorphTarget& target : primitive.morph_targets) {
      EXPECT_TRUE(target.positions.empty() || target.positions.size() == vertices);
    }
    if (primitive.material == kNone || primitive.topology != Topology::triangles) continue;
    const Material& material = scene.materials.at(static_cast<std::size_t>(primitive.material));
    if (material.normal_texture.present() && !material.unlit) {
      EXPECT_EQ(primitive.vertices.tangents.size(), vertices);
    }
  }
  for (const Image& image : scene.images) EXPECT_EQ(image.rgba.size(), std::size_t{4} * image.width * image.height);
}

TEST_F(GltfAssets, AllConformingFilesRead) {
  // The generator's README: 04 asks for glTF 2.1, 05 for an extension that does not exist. The others hold KTX2 images,
  // or require clearcoat or iridescence.
  const std::set<std::string> refused = {"Compatibility_04.gltf", "Compatibility_05.gltf",  "AnisotropyBarnLamp.gltf",
                                         "ClearCoatCarPaint.glb", "IridescenceSuzanne.glb", "StainedGlassLamp.gltf"};
  for (const char* folder : {"conformance", "objects", "animated", "architecture", "humans", "foliage"}) {
    for (const fs::path& file : files(folder)) {
      SCOPED_TRACE(file.string());
      if (refused.contains(file.filename())) {
        expect_error(ErrorCode::unsupported, "", [&] { static_cast<void>(read_gltf(file)); });
        continue;
      }
      try {
        const Scene scene = read_gltf(file);
        EXPECT_FALSE(scene.primitives.empty());
        expect_sound(scene);
      } catch (const Error& error) { ADD_FAILURE() << error.what(); }
    }
  }
}

// Errors of the official validator that leave no sure reading, as far as the core specification goes.
const std::set<std::string>& unreadable_codes() {
  static const std::set<std::string> codes = {"ACCESSOR_INDEX_OOB",
                                              "ACCESSOR_INDEX_PRIMITIVE_RESTART",
                                              "ACCESSOR_NORMALIZED_INVALID",
                                              "ACCESSOR_OFFSET_ALIGNMENT",
                                              "ACCESSOR_SMALL_BYTESTRIDE",
                                              "ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE",
                                              "ACCESSOR_TOO_LONG",
                                              "ACCESSOR_WEIGHTS_NEGATIVE",
                                              "ANIMATION_CHANNEL_TARGET_NODE_MATRIX",
                                              "ANIMATION_DUPLICATE_TARGETS",
                                              "ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT",
                                              "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT",
                                              "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT",
                                              "BUFFER_BYTE_LENGTH_MISMATCH",
                                              "BUFFER_VIEW_TOO_LONG",
                                              "CAMERA_XMAG_YMAG_ZERO",
                                              "CAMERA_ZFAR_LEQUAL_ZNEAR",
                                              "GLB_CHUNK_TOO_BIG",
                                              "GLB_INVALID_MAGIC",
                                              "GLB_INVALID_VERSION",
                                              "GLB_LENGTH_TOO_SMALL",
                                              "GLB_UNEXPECTED_END_OF_CHUNK_DATA",
                                              "GLB_UNEXPECTED_FIRST_CHUNK",
                                              "MESH_INVALID_WEIGHTS_COUNT",
                                              "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT",
                                              "MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT",
                                              "MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH",
                                              "MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT",
                                              "NODE_LOOP",
                                              "NODE_MATRIX_TRS",
                                              "NODE_PARENT_OVERRIDE",
                                              "NODE_WEIGHTS_INVALID",
                                              "PATTERN_MISMATCH",
                                              "SCENE_NON_ROOT_NODE",
                                              "SKIN_IBM_INVALID_FORMAT",
                                              "UNKNOWN_ASSET_MAJOR_VERSION",
                                              "UNRESOLVED_REFERENCE"};
  return codes;
}

// The pointers of such errors in a validator's report; "" for errors of the container, which have none.
std::set<std::string> unreadable_places(const fs::path& report) {
  std::set<std::string> places;
  const Json json = Json::parse(std::ifstream(report));
  for (const Json& message : json["issues"]["messages"]) {
    const std::string pointer = message.value("pointer", "");
    // What stands in the object of an extension that is not supported is not read.
    const bool extension = pointer.find("/extensions/") != std::string::npos;
    if (message["severity"] == 0 && !extension && unreadable_codes().contains(message["code"])) places.insert(pointer);
  }
  return places;
}

TEST_F(GltfAssets, UnreadableFilesAreRefused) {
  std::size_t refused = 0, same_place = 0;
  for (const fs::path& file : files("malformed")) {
    SCOPED_TRACE(file.string());
    const fs::path report = file.string() + ".report.json";
    const std::set<std::string> places = fs::exists(report) ? unreadable_places(report) : std::set<std::string>();
    std::string message;
    try {
      static_cast<void>(read_gltf(file));
    } catch (const Error& error) { message = error.what(); }
    if (places.empty()) continue;
    EXPECT_NE(message, "") << "read, although " << *places.begin() << " is wrong";
    ++refused;
    same_place += std::any_of(places.begin(), places.end(), [&](const std::string& place) {
      return message.find(": " + place) != std::string::npos;
    });
  }
  // Files with several faults are refused at the first that the reader meets, which need not be the validator's.
  EXPECT_GE(same_place * 10, refused * 9) << same_place << " of " << refused << " refusals name the validator's place";
}

}  // namespace
}  // namespace velarium::scene::test
