// Volumes in which environment light is multiplied, as the extras of nodes make them. The schema in docs is held to the
// reader: what it allows is read without a warning, what it forbids is warned of and ignored.

#include "gltf_model.hpp"
#include "scene/snapshot.hpp"

#include <gtest/gtest.h>

namespace velarium::scene::test {
namespace {

Model with_ambient_light(const Json& value) {
  Model model;
  model.root["nodes"] = Json::parse(R"([{"name": "other"}, {"translation": [1, 2, 3], "scale": [2, 1, 1]}])");
  model.root["nodes"][1]["extras"]["ambient_light"] = value;
  return model;
}

Model with_member(const std::string& member, const Json& value) {
  Json light = Json::parse(R"({"color": [0.4, 0.4, 0.5], "range": 3})");
  light[member] = value;
  return with_ambient_light(light);
}

Json schema_of_light() {
  std::ifstream file(VELARIUM_DOCS "/ambient_light_extras.schema.json");
  return Json::parse(file)["properties"]["ambient_light"];
}

void expect_ignored(const Model& model, const std::string& warning) {
  const Scene scene = read(model);
  EXPECT_TRUE(scene.ambient_lights.empty()) << warning;
  EXPECT_TRUE(has_warning(scene, "/nodes/1/extras/ambient_light" + warning)) << warning;
}

TEST(AmbientLights, StandAtTheirNodes) {
  const Scene scene = read(with_ambient_light(Json::parse(R"({"color": [0.5, 1, 2], "range": 3})")));
  ASSERT_EQ(scene.ambient_lights.size(), 1u);
  EXPECT_TRUE(scene.warnings.empty());
  const AmbientLight& light = scene.ambient_lights[0];
  EXPECT_EQ(light.node, 1u);
  EXPECT_EQ(light.color, glm::vec3(0.5f, 1.0f, 2.0f));
  EXPECT_EQ(light.range, 3.0f);
  const SceneSnapshot snapshot = snapshot_at(scene, 0.0f, "");
  ASSERT_EQ(snapshot.ambient_lights.size(), 1u);
  const AmbientLightInstance& instance = snapshot.ambient_lights[0];
  EXPECT_EQ(instance.light.color, light.color);
  EXPECT_EQ(instance.world_from_node[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(instance.world_from_node[0], glm::dvec4(2, 0, 0, 0));
}

TEST(AmbientLights, MoveWithTheirNodes) {
  Model model = with_member("range", 1);
  const int times = model.add<float>("SCALAR", kFloat, 2, {0.0f, 1.0f});
  model.root["accessors"][times]["min"] = {0.0f};
  model.root["accessors"][times]["max"] = {1.0f};
  const int places = model.add<float>("VEC3", kFloat, 2, {0, 0, 0, 4, 0, 0});
  model.root["animations"] = {{{"samplers", {{{"input", times}, {"output", places}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
  const Scene scene = read(model);
  EXPECT_EQ(snapshot_at(scene, 0.5f, "").ambient_lights.at(0).world_from_node[3], glm::dvec4(2, 0, 0, 1));
}

TEST(AmbientLights, OfNodesThatAreNotShownAreDark) {
  Model model = with_member("range", 1);
  model.root["scenes"] = {{{"nodes", {0}}}};
  const Scene scene = read(model);
  EXPECT_EQ(scene.ambient_lights.size(), 1u);
  EXPECT_TRUE(snapshot_at(scene, 0.0f, "").ambient_lights.empty());
}

TEST(AmbientLights, WhatIsNoneIsIgnored) {
  expect_ignored(with_ambient_light(Json::parse(R"({"range": 3})")), ": has no color or no range; it is ignored");
  expect_ignored(with_ambient_light(Json::parse(R"({"color": [1, 1, 1]})")), ": has no color or no range");
  for (const char* color :
       {"[1, 1]", "[1, 1, 1, 1]", "[1, -0.1, 1]", "[1, 17, 1]", "[1, \"1\", 1]", "0.5", "[1, 1, 1e300]"})
    expect_ignored(with_member("color", Json::parse(color)),
                   "/color: is not three numbers from 0 to 16; it is ignored");
  for (const char* range : {"0", "-1", "\"3\"", "1e300", "[3]", "null"})
    expect_ignored(with_member("range", Json::parse(range)),
                   "/range: is not a number of metres above 0; it is ignored");
}

TEST(AmbientLights, ExtrasOfOthersAreLeftAlone) {
  for (const char* value : {"7", "\"lamp\"", "[1, 2]", "null"}) {
    const Scene scene = read(with_ambient_light(Json::parse(value)));
    EXPECT_TRUE(scene.ambient_lights.empty()) << value;
    EXPECT_TRUE(scene.warnings.empty()) << value;
  }
}

TEST(AmbientLights, AreAtMost256) {
  Model model = with_member("range", 1);
  const Json node = model.root["nodes"][1];
  for (int i = 1; i < 258; ++i) model.root["nodes"].push_back(node);
  const Scene scene = read(model);
  EXPECT_EQ(scene.ambient_lights.size(), 256u);
  EXPECT_TRUE(has_warning(scene, "/nodes/257/extras/ambient_light: is one of more than 256 ambient lights"));
}

TEST(AmbientLightSchema, ExamplesAreReadWithoutWarning) {
  const Json light = schema_of_light();
  for (const auto& [member, rule] : light["properties"].items())
    for (const Json& example : rule.at("examples")) {
      const Scene scene = read(with_member(member, example));
      EXPECT_EQ(scene.ambient_lights.size(), 1u) << member << " " << example;
      EXPECT_TRUE(scene.warnings.empty()) << member << " " << example;
    }
  for (const Json& example : light["examples"]) EXPECT_EQ(read(with_ambient_light(example)).ambient_lights.size(), 1u);
}

TEST(AmbientLightSchema, WhatItForbidsIsWarnedOf) {
  const Json light = schema_of_light();
  for (const Json& member : light["required"]) {
    Json without = light["examples"][0];
    without.erase(member.get<std::string>());
    expect_ignored(with_ambient_light(without), "");
  }
  const Json& channel = light["properties"]["color"]["items"];
  for (const double number : {channel["minimum"].get<double>() - 0.01, channel["maximum"].get<double>() + 0.01})
    expect_ignored(with_member("color", {number, 1, 1}), "/color");
  expect_ignored(with_member("range", light["properties"]["range"]["exclusiveMinimum"]), "/range");
}

}  // namespace
}  // namespace velarium::scene::test
