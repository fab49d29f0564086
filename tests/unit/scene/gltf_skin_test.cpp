#include "gltf_model.hpp"

namespace velarium::scene::test {
namespace {

// The triangle with two sets of joints; nodes 1 and 2 are the joints of its skin.
Model skinned() {
  Model model = triangle();
  model.root["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, Json::object()};
  model.root["scenes"][0]["nodes"] = {0, 1};
  model.root["skins"] = {{{"joints", {1, 2}}}};
  Json& attributes = model.primitive()["attributes"];
  attributes["JOINTS_0"] = model.add<std::uint8_t>("VEC4", kUnsignedByte, 3, {0, 1, 0, 0, 1, 0, 9, 0, 0, 0, 0, 0});
  attributes["WEIGHTS_0"] = model.add<float>("VEC4", kFloat, 3, {1, 2, 0, 0, 0.5f, 0, 0, 0, 0, 0, 0, 0});
  attributes["JOINTS_1"] = model.add<std::uint16_t>("VEC4", kUnsignedShort, 3, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  attributes["WEIGHTS_1"] =
      model.add<std::uint8_t>("VEC4", kUnsignedByte, 3, {255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, true);
  return model;
}

TEST(GltfSkin, WeightsOfAllSetsSumToOne) {
  const Scene scene = read(skinned());
  const Primitive& primitive = scene.primitives.at(0);
  EXPECT_EQ(primitive.skin_sets, 2u);
  ASSERT_EQ(primitive.joints.size(), 6u);
  EXPECT_EQ(primitive.weights.at(0), glm::vec4(0.25f, 0.5f, 0, 0));  // 1, 2 and, in the second set, 1
  EXPECT_EQ(primitive.weights.at(3), glm::vec4(0.25f, 0, 0, 0));
  EXPECT_EQ(primitive.joints.at(3), glm::u16vec4(1, 0, 0, 0));
  EXPECT_EQ(primitive.weights.at(1), glm::vec4(1, 0, 0, 0));
  EXPECT_EQ(primitive.joints.at(1), glm::u16vec4(1, 0, 0, 0)) << "a joint of no weight is not looked at";
  EXPECT_EQ(primitive.weights.at(2), glm::vec4(1, 0, 0, 0));
  EXPECT_TRUE(has_warning(scene, "vertices have no joint weights"));
}

TEST(GltfSkin, MatricesAreOptional) {
  Model model = skinned();
  EXPECT_EQ(read(model).skins.at(0).joint_from_object, (std::vector<glm::mat4>(2, glm::mat4(1.0f))));
  std::vector<float> matrices(32, 0.0f);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 4; ++j) matrices[static_cast<std::size_t>(i * 16 + j * 5)] = 1.0f;
  }
  matrices[16 + 12] = 7.0f;  // translation x of the second
  model.root["skins"][0]["inverseBindMatrices"] = model.add<float>("MAT4", kFloat, 2, matrices);
  EXPECT_EQ(read(model).skins.at(0).joint_from_object.at(1)[3], glm::vec4(7, 0, 0, 1));
  matrices[3] = 0.5f;
  model.root["skins"][0]["inverseBindMatrices"] = model.add<float>("MAT4", kFloat, 2, matrices);
  expect_refused(model, "/skins/0/inverseBindMatrices: element 3 of a matrix is 0.5, must be 0");
  matrices.resize(16);
  matrices[3] = 0.0f;
  model.root["skins"][0]["inverseBindMatrices"] = model.add<float>("MAT4", kFloat, 1, matrices);
  expect_refused(model, "/skins/0/inverseBindMatrices: has 1 matrices, fewer than the 2 joints");
}

TEST(GltfSkin, WhatDoesNotFitIsRefused) {
  const auto refuse = [](const std::function<void(Model&)>& spoil, const std::string& part) {
    Model model = skinned();
    spoil(model);
    expect_refused(model, part);
  };
  refuse([](Model& m) { m.root["skins"][0]["joints"] = Json::array(); }, "/skins/0/joints: is empty");
  refuse([](Model& m) { m.root["skins"][0]["joints"] = {1, 3}; }, "/skins/0/joints/1: is 3, but there are 3 nodes");
  refuse([](Model& m) { m.root["skins"][0]["skeleton"] = 3; }, "/skins/0/skeleton: is 3");
  refuse([](Model& m) { m.root["nodes"][0]["skin"] = 1; }, "/nodes/0/skin: is 1, but there are 1 skins");
  refuse([](Model& m) { m.root["skins"][0]["joints"] = {1}; },
         "/nodes/0/skin: has 1 joints, but /meshes/0 asks for joint 1");
  refuse([](Model& m) { m.primitive()["attributes"].erase("WEIGHTS_1"); },
         "/meshes/0/primitives/0/attributes: has 2 sets of joints, but 1 of weights");
  refuse(
      [](Model& m) {
        m.primitive()["attributes"].erase("JOINTS_0");
        m.primitive()["attributes"].erase("WEIGHTS_0");
      },
      "/meshes/0/primitives/0/attributes: has no property 'JOINTS_0'");
  refuse(
      [](Model& m) {
        m.primitive()["attributes"]["WEIGHTS_0"] =
            m.add<float>("VEC4", kFloat, 3, {1, 0, 0, 0, -1, 2, 0, 0, 1, 0, 0, 0});
      },
      "/meshes/0/primitives/0/attributes: vertex 1 has joint weights that are negative");
  refuse([](Model& m) { m.root["meshes"][0]["primitives"].push_back(triangle().primitive()); },
         "/nodes/0/skin: belongs to a mesh of which some primitives have joints");
}

TEST(GltfSkin, ASkinWithoutUseIsIgnoredWithAWarning) {
  Model model = skinned();
  model.primitive() = triangle().primitive();
  const Scene rigid = read(model);
  EXPECT_EQ(rigid.nodes.at(0).skin, kNone);
  EXPECT_TRUE(has_warning(rigid, "/nodes/0/skin: belongs to a mesh without joints"));
  model.root["nodes"][0].erase("mesh");
  EXPECT_TRUE(has_warning(read(model), "/nodes/0/skin: belongs to a node without a mesh"));
}

}  // namespace
}  // namespace velarium::scene::test
