#include "gltf_model.hpp"

#include <glm/geometric.hpp>

namespace velarium::scene::test {
namespace {

using Indices = std::vector<std::uint32_t>;

// Five vertices in some plane, indexed as given, without normals.
Model five_vertices(int mode, const std::vector<std::uint8_t>& indices) {
  Model model = triangle();
  const int positions = model.add<float>("VEC3", kFloat, 5, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 0, 0});
  model.primitive() = {{"attributes", {{"POSITION", positions}}}, {"mode", mode}};
  if (!indices.empty()) {
    model.primitive()["indices"] = model.add<std::uint8_t>("SCALAR", kUnsignedByte, indices.size(), indices);
  }
  return model;
}

// Positions that the list of a primitive draws, as x + 10 y, whatever was split on the way.
std::vector<int> drawn(const Scene& scene) {
  std::vector<int> corners;
  const Primitive& primitive = scene.primitives.at(0);
  for (const std::uint32_t index : primitive.indices) {
    const glm::vec3& p = primitive.vertices.positions.at(index);
    corners.push_back(static_cast<int>(p.x + 10 * p.y));
  }
  return corners;
}

// Vertices 0 to 4 are, in that notation:
constexpr int A = 0, B = 1, C = 10, D = 11, E = 2;

TEST(GltfMesh, ModesBecomeLists) {  // glTF 2.0, 3.7.2.1
  EXPECT_EQ(drawn(read(five_vertices(0, {}))), (std::vector<int>{A, B, C, D, E}));
  EXPECT_EQ(drawn(read(five_vertices(1, {0, 1, 2, 3}))), (std::vector<int>{A, B, C, D}));
  EXPECT_EQ(drawn(read(five_vertices(2, {0, 1, 2}))), (std::vector<int>{A, B, B, C, C, A}));
  EXPECT_EQ(drawn(read(five_vertices(3, {0, 1, 2}))), (std::vector<int>{A, B, B, C}));
  EXPECT_EQ(drawn(read(five_vertices(4, {0, 1, 2}))), (std::vector<int>{A, B, C}));
  EXPECT_EQ(drawn(read(five_vertices(5, {}))), (std::vector<int>{A, B, C, B, D, C, C, D, E}));
  EXPECT_EQ(drawn(read(five_vertices(6, {}))), (std::vector<int>{B, C, A, C, D, A, D, E, A}));
  expect_refused(five_vertices(7, {}), "/meshes/0/primitives/0/mode: is 7");
}

TEST(GltfMesh, TopologyFollowsTheMode) {
  for (const auto& [mode, topology] : {std::pair{0, Topology::points},
                                       {1, Topology::lines},
                                       {2, Topology::lines},
                                       {3, Topology::lines},
                                       {4, Topology::triangles},
                                       {5, Topology::triangles},
                                       {6, Topology::triangles}}) {
    EXPECT_EQ(read(five_vertices(mode, {0, 1, 2, 3, 4, 0})).primitives.at(0).topology, topology) << mode;
  }
}

TEST(GltfMesh, LeftOverVerticesAreIgnoredWithAWarning) {
  const Scene scene = read(five_vertices(4, {0, 1, 2, 3, 4}));
  EXPECT_EQ(drawn(scene), (std::vector<int>{A, B, C}));
  EXPECT_TRUE(has_warning(scene, "/meshes/0/primitives/0: its last vertices"));
  const Scene nothing = read(five_vertices(5, {0, 1}));
  EXPECT_TRUE(nothing.primitives.empty());
  EXPECT_TRUE(nothing.meshes.at(0).primitives.empty());
  EXPECT_TRUE(has_warning(nothing, "its last vertices"));
}

TEST(GltfMesh, IndicesAreChecked) {
  expect_refused(five_vertices(4, {0, 1, 5}),
                 "/meshes/0/primitives/0/indices: index number 2 is 5, but there are 5 vertices");
  expect_refused(five_vertices(4, {0, 255, 2}),
                 "/meshes/0/primitives/0/indices: index number 1 is the primitive restart value");
  Model model = triangle();
  model.primitive()["indices"] = model.add<float>("SCALAR", kFloat, 3, {0, 1, 2});
  expect_refused(model, "/meshes/0/primitives/0/indices: is an accessor of SCALAR FLOAT");
  model.primitive()["indices"] = 99;
  expect_refused(model, "/meshes/0/primitives/0/indices: is 99, but there are 3 accessors");
}

TEST(GltfMesh, RestartValueIsRefusedEvenWhereAVertexHasIt) {
  Model model = triangle();
  model.primitive() = {{"attributes", {{"POSITION", model.add<float>("VEC3", kFloat, 256, std::vector<float>(768))}}},
                       {"indices", model.add<std::uint8_t>("SCALAR", kUnsignedByte, 3, {0, 254, 255})}};
  expect_refused(model, "/meshes/0/primitives/0/indices: index number 2 is the primitive restart value");
}

TEST(GltfMesh, IndicesOfEveryWidth) {
  Model model = triangle();
  model.primitive()["indices"] = model.add<std::uint8_t>("SCALAR", kUnsignedByte, 3, {2, 1, 0});
  EXPECT_EQ(read(model).primitives.at(0).indices, (Indices{2, 1, 0}));
  model.primitive()["indices"] = model.add<std::uint16_t>("SCALAR", kUnsignedShort, 3, {1, 0, 2});
  EXPECT_EQ(read(model).primitives.at(0).indices, (Indices{1, 0, 2}));
  model.primitive()["indices"] = model.add<std::uint32_t>("SCALAR", kUnsignedInt, 3, {0, 2, 1});
  EXPECT_EQ(read(model).primitives.at(0).indices, (Indices{0, 2, 1}));
  model.primitive().erase("indices");
  EXPECT_EQ(read(model).primitives.at(0).indices, (Indices{0, 1, 2}));
}

TEST(GltfMesh, AbsentNormalsAreFlatAndTangentsWithThemIgnored) {
  Model model = triangle();
  model.primitive()["attributes"].erase("NORMAL");
  model.primitive()["attributes"]["TANGENT"] =
      model.add<float>("VEC4", kFloat, 3, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  const Scene scene = read(model);
  EXPECT_EQ(scene.primitives.at(0).vertices.normals, (std::vector<glm::vec3>(3, glm::vec3(0, 0, 1))));
  EXPECT_TRUE(scene.primitives.at(0).vertices.tangents.empty());
  EXPECT_TRUE(read(five_vertices(1, {0, 1})).primitives.at(0).vertices.normals.empty());
}

TEST(GltfMesh, DirectionsBecomeUnit) {
  Model model = triangle();
  model.primitive()["attributes"]["NORMAL"] = model.add<float>("VEC3", kFloat, 3, {0, 0, 2, 0, 3, 4, 0, 0, 0});
  model.primitive()["attributes"]["TANGENT"] =
      model.add<float>("VEC4", kFloat, 3, {2, 0, 0, -1, 1, 0, 0, 1, 0, 0, 0, 0.5f});
  const Scene scene = read(model);
  const VertexFrames& vertices = scene.primitives.at(0).vertices;
  EXPECT_EQ(vertices.normals.at(0), glm::vec3(0, 0, 1));
  EXPECT_LT(glm::distance(vertices.normals.at(1), glm::vec3(0, 0.6f, 0.8f)), 1e-6f);
  EXPECT_FLOAT_EQ(glm::length(vertices.normals.at(2)), 1.0f);
  EXPECT_EQ(vertices.tangents.at(0), glm::vec4(1, 0, 0, -1));
  EXPECT_FLOAT_EQ(glm::length(glm::vec3(vertices.tangents.at(2))), 1.0f);
  EXPECT_EQ(vertices.tangents.at(2).w, 1.0f);
  EXPECT_TRUE(has_warning(scene, "NORMAL: has directions that are not of unit length"));
  EXPECT_TRUE(has_warning(scene, "NORMAL: has directions of no length"));
  EXPECT_TRUE(has_warning(scene, "TANGENT: has signs"));
}

TEST(GltfMesh, NormalMapsGetTangents) {
  Model model = triangle();
  model.root["textures"] = {Json::object()};
  model.root["materials"] = {{{"normalTexture", {{"index", 0}, {"texCoord", 1}}}}};
  model.primitive()["material"] = 0;
  model.primitive()["attributes"]["TEXCOORD_1"] = model.add<float>("VEC2", kFloat, 3, {0, 0, 0, 1, 1, 0});
  const Scene scene = read(model);
  // u grows with y of the position: the tangent is +Y. v grows with x, and the map's green axis points against v
  // (glTF 2.0, 3.8.3), so that the bitangent is -X, which is also normal x tangent: the sign is +1.
  ASSERT_EQ(scene.primitives.at(0).vertices.tangents.size(), 3u);
  EXPECT_LT(glm::distance(scene.primitives.at(0).vertices.tangents.at(0), glm::vec4(0, 1, 0, 1)), 1e-5f);
  model.root["materials"][0]["extensions"]["KHR_materials_unlit"] = Json::object();
  EXPECT_TRUE(read(model).primitives.at(0).vertices.tangents.empty()) << "unlit materials show no normal map";
}

TEST(GltfMesh, ColoursOfEveryFormat) {
  const auto colors = [](Model model, int accessor) {
    model.primitive()["attributes"]["COLOR_0"] = accessor;
    return read(model).primitives.at(0).colors.at(0);
  };
  Model model = triangle();
  const int rgb = model.add<float>("VEC3", kFloat, 3, {0.25f, 0.5f, 1, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(colors(model, rgb), glm::vec4(0.25f, 0.5f, 1, 1));
  const int bytes = model.add<std::uint8_t>("VEC4", kUnsignedByte, 3, {51, 255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0}, true);
  EXPECT_EQ(colors(model, bytes), glm::vec4(0.2f, 1, 0, 0.2f));
  const int shorts = model.add<std::uint16_t>("VEC3", kUnsignedShort, 3, {13107, 65535, 0, 0, 0, 0, 0, 0, 0}, true);
  EXPECT_EQ(colors(model, shorts), glm::vec4(0.2f, 1, 0, 1));
  const int wild = model.add<float>("VEC4", kFloat, 3, {2, -1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(colors(model, wild), glm::vec4(1, 0, 0, 1));
}

TEST(GltfMesh, AttributesAgreeInCountAndFormat) {
  Model model = triangle();
  model.primitive()["attributes"]["TEXCOORD_0"] = model.add<float>("VEC2", kFloat, 2, {0, 0, 0, 0});
  expect_refused(model, "/meshes/0/primitives/0/attributes/TEXCOORD_0: has 2 elements, but there are 3 vertices");
  model.primitive()["attributes"]["TEXCOORD_0"] = model.add<std::int16_t>("VEC2", kShort, 3, {0, 0, 0, 0, 0, 0});
  expect_refused(model, "/meshes/0/primitives/0/attributes/TEXCOORD_0: is an accessor of VEC2 SHORT");
  model.primitive()["attributes"].erase("TEXCOORD_0");
  model.primitive()["attributes"]["_OWN"] = 77;
  expect_refused(model, "/meshes/0/primitives/0/attributes/_OWN: is 77, but there are");
}

TEST(GltfMesh, EightSetsOfTextureCoordinates) {
  Model model = triangle();
  for (int set = 0; set < 9; ++set) {
    const auto value = static_cast<float>(set);
    model.primitive()["attributes"]["TEXCOORD_" + std::to_string(set)] =
        model.add<float>("VEC2", kFloat, 3, std::vector<float>(6, value));
  }
  const Scene scene = read(model);
  for (std::size_t set = 0; set < kMaxUvSets; ++set) {
    EXPECT_EQ(scene.primitives.at(0).uv[set].at(2), glm::vec2(static_cast<float>(set)));
  }
  EXPECT_TRUE(has_warning(scene, "TEXCOORD_8: only the first 8 sets"));
}

// Shares of 1 whose accessor does not say so.
TEST(GltfMesh, IntegersAreNormalisedWhereOnlyTheMarkIsMissing) {
  Model model = triangle();
  model.primitive()["attributes"]["COLOR_0"] =
      model.add<std::uint8_t>("VEC4", kUnsignedByte, 3, {51, 255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0});
  model.primitive()["attributes"]["TEXCOORD_0"] =
      model.add<std::uint16_t>("VEC2", kUnsignedShort, 3, {65535, 0, 0, 0, 0, 0});
  const Scene scene = expect_repaired(model, "/TEXCOORD_0: is an accessor of VEC2 UNSIGNED_SHORT; it was read as norm");
  EXPECT_TRUE(has_warning(scene, "/COLOR_0: is an accessor of VEC4 UNSIGNED_BYTE; it was read as normalized"));
  const Primitive& primitive = scene.primitives.at(0);
  EXPECT_EQ(primitive.colors.at(0), glm::vec4(0.2f, 1, 0, 0.2f));
  EXPECT_EQ(primitive.uv[0].at(0), glm::vec2(1, 0));
  // Where integers are allowed as they are, they are meant.
  model.root["extensionsUsed"] = {"KHR_mesh_quantization"};
  EXPECT_EQ(read(model).primitives.at(0).uv[0].at(0), glm::vec2(65535, 0));
}

TEST(GltfMesh, NormalsOfNoLengthAreThoseOfTheTriangles) {
  Model model = triangle();
  model.primitive()["attributes"]["NORMAL"] = model.add<float>("VEC3", kFloat, 3, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  const Scene scene = expect_repaired(model, "/NORMAL: has directions of no length");
  const std::vector<glm::vec3> wanted{{0, 0, 1}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(scene.primitives.at(0).vertices.normals, wanted);
}

TEST(GltfMesh, BoundsFollowIndices) {
  Model model = triangle();
  model.primitive()["attributes"]["POSITION"] = model.add<float>("VEC3", kFloat, 3, {0, 0, 0, 1, 0, 0, 900, 900, 900});
  model.primitive()["indices"] = model.add<std::uint8_t>("SCALAR", kUnsignedByte, 3, {0, 1, 1});
  const Scene scene = read(model);
  EXPECT_EQ(scene.primitives.at(0).bounds.max, glm::vec3(1, 0, 0));
}

TEST(GltfMesh, WithoutPositionsItIsLeftOut) {
  Model model = triangle();
  model.primitive()["attributes"].erase("POSITION");
  const Scene scene = read(model);
  EXPECT_TRUE(scene.primitives.empty());
  EXPECT_TRUE(has_warning(scene, "/meshes/0/primitives/0: has no positions"));
}

TEST(GltfMesh, ShapeOfTheJsonIsChecked) {
  Model model = triangle();
  model.root["meshes"][0]["primitives"] = Json::array();
  expect_refused(model, "/meshes/0/primitives: is empty");
  model.root["meshes"][0] = Json::object();
  expect_refused(model, "/meshes/0: has no property 'primitives'");
  model.root["meshes"] = Json::object();
  expect_refused(model, "/meshes: is an object, must be an array");
  model = triangle();
  model.primitive()["material"] = 0;
  expect_refused(model, "/meshes/0/primitives/0/material: is 0, but there are 0 materials");
}

// --- morph targets ----------------------------------------------------------------------------------------------

Model morphing() {
  Model model = triangle();
  const int up = model.add<float>("VEC3", kFloat, 3, {0, 0, 1, 0, 0, 2, 0, 0, 3});
  model.primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", up}, {"NORMAL", up}}};
  model.root["meshes"][0]["weights"] = {0.25, 0.5};
  return model;
}

TEST(GltfMorph, TargetsAreDisplacements) {
  const Scene scene = read(morphing());
  const auto& targets = scene.primitives.at(0).morph_targets;
  ASSERT_EQ(targets.size(), 2u);
  EXPECT_EQ(targets[0].positions.at(2), glm::vec3(0, 0, 3));
  EXPECT_TRUE(targets[0].normals.empty());
  EXPECT_EQ(targets[1].normals.at(1), glm::vec3(0, 0, 2));
  EXPECT_EQ(scene.meshes.at(0).weights, (std::vector<float>{0.25f, 0.5f}));
}

TEST(GltfMorph, OtherAttributesAreIgnoredWithOneWarning) {
  Model model = morphing();
  for (Json& target : model.primitive()["targets"]) target["COLOR_0"] = 1;
  const Scene scene = read(model);
  EXPECT_EQ(scene.warnings.size(), 1u);
  EXPECT_TRUE(has_warning(scene, "/targets/0/COLOR_0: only positions, normals and tangents are morphed"));
}

TEST(GltfMorph, CountsAgree) {
  Model model = morphing();
  model.root["meshes"][0]["weights"] = {1};
  expect_refused(model, "/meshes/0/weights: has 1 weights, but the mesh has 2 morph targets");
  model = morphing();
  model.root["meshes"][0]["primitives"].push_back(triangle().primitive());
  expect_refused(model, "/meshes/0/primitives/1: has 0 morph targets");
  model = morphing();
  model.root["nodes"][0]["weights"] = {1};
  expect_refused(model, "/nodes/0/weights: has 1 weights, but its mesh has 2 morph targets");
  model = morphing();
  model.primitive()["targets"][0]["POSITION"] = model.add<float>("VEC3", kFloat, 1, {0, 0, 1});
  expect_refused(model, "/meshes/0/primitives/0/targets/0/POSITION: has 1 elements");
}

}  // namespace
}  // namespace velarium::scene::test
