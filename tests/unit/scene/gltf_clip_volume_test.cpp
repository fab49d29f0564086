#include "gltf_model.hpp"

#include "scene/snapshot.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::scene::test {
namespace {

bool holds(const ClipVolume& volume, const glm::vec3& point) {
  return std::ranges::all_of(
      volume.planes, [&](const glm::vec4& plane) { return glm::dot(glm::vec3(plane), point) + plane.w >= 0.0f; });
}

Model with_node_extras(const char* extras) {
  Model model;
  model.root["nodes"] = Json::parse(R"([{"name": "other"}, {"translation": [1, 2, 3]}])");
  model.root["nodes"][1]["extras"] = Json::parse(extras);
  return model;
}

TEST(ClipVolume, ABoxOfItsHalfSize) {
  const Scene scene = read(with_node_extras(R"({"clip_volume": {"name": "hall", "half_size": [4, 2, 6]}})"));
  ASSERT_EQ(scene.clip_volumes.size(), 1u);
  const ClipVolume& hall = scene.clip_volumes[0];
  EXPECT_EQ(hall.name, "hall");
  EXPECT_EQ(hall.node, 1u);
  EXPECT_EQ(hall.planes.size(), 6u);
  EXPECT_TRUE(holds(hall, {3.99f, -1.99f, 5.99f}));
  for (const glm::vec3& outside : {glm::vec3(4.01f, 0, 0), glm::vec3(0, -2.01f, 0), glm::vec3(0, 0, 6.01f)})
    EXPECT_FALSE(holds(hall, outside));
  EXPECT_EQ(hall.bounds.min, glm::vec3(-4, -2, -6));
  EXPECT_EQ(snapshot_at(scene, 0.0f, "").world_from_clip_volume.at(0)[3], glm::dvec4(1, 2, 3, 1));
}

// A prism of `sides` sides about the Y axis, one metre around and two high, open above and below.
Model prism(int sides, float dent = 0.0f) {
  Model model = with_node_extras(R"({"clip_volume": {"name": "tower"}})");
  std::vector<float> positions;
  for (int i = 0; i < sides; ++i) {
    const auto corner = [&](int at, float y) {
      const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(at) / static_cast<float>(sides);
      const float radius = at == 1 ? 1.0f - dent : 1.0f;
      positions.insert(positions.end(), {radius * std::cos(turn), y, radius * std::sin(turn)});
    };
    const int next = (i + 1) % sides;
    for (const auto& [at, y] : {std::pair{i, -1.0f}, {next, -1.0f}, {next, 1.0f}, {i, -1.0f}, {next, 1.0f}, {i, 1.0f}})
      corner(at, y);
  }
  const int position = model.add<float>("VEC3", kFloat, positions.size() / 3, positions);
  model.root["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", position}}}}}}}};
  model.root["nodes"][1]["mesh"] = 0;
  return model;
}

TEST(ClipVolume, AMeshClosedByItsBoxAndNotDrawn) {
  const Scene scene = read(prism(8));
  ASSERT_EQ(scene.clip_volumes.size(), 1u);
  const ClipVolume& tower = scene.clip_volumes[0];
  // Eight sides between the axes, and the four sides and two ends of the box.
  EXPECT_EQ(tower.planes.size(), 14u);
  const float side = std::cos(std::numbers::pi_v<float> / 8.0f);  // from the axis to the middle of a side
  const glm::vec3 towards(std::cos(std::numbers::pi_v<float> / 8.0f), 0, std::sin(std::numbers::pi_v<float> / 8.0f));
  EXPECT_TRUE(holds(tower, 0.999f * side * towards + glm::vec3(0, 0.99f, 0)));
  EXPECT_FALSE(holds(tower, 1.001f * side * towards));
  EXPECT_FALSE(holds(tower, {0, 1.01f, 0}));
  EXPECT_TRUE(snapshot_at(scene, 0.0f, "").instances.empty());
}

// Ignored with this warning at the volume, or at a member of it.
void expect_ignored(const Model& model, const std::string& warning) {
  const Scene scene = read(model);
  EXPECT_TRUE(scene.clip_volumes.empty()) << warning;
  EXPECT_TRUE(has_warning(scene, "/nodes/1/extras/clip_volume" + warning)) << warning;
}

TEST(ClipVolume, MeshesThatAreNoConvexVolumeAreDrawnAsEver) {
  expect_ignored(prism(8, 0.5f), ": is a mesh that is not convex; it is ignored");
  EXPECT_EQ(read(prism(58)).clip_volumes.size(), 1u);
  expect_ignored(prism(60), ": is a mesh of more than 64 faces");
  EXPECT_EQ(snapshot_at(read(prism(60)), 0.0f, "").instances.size(), 1u);
}

TEST(ClipVolume, WhatIsNoVolumeIsIgnored) {
  expect_ignored(with_node_extras(R"({"clip_volume": {"name": "x"}})"), ": has no half_size, and its node no mesh");
  expect_ignored(with_node_extras(R"({"clip_volume": {"half_size": [1, 1, 1]}})"), ": has no name");
  expect_ignored(with_node_extras(R"({"clip_volume": {"name": 7, "half_size": [1, 1, 1]}})"), ": has no name");
  for (const char* size : {"[1, 0, 1]", "[1, 1]", "\"1\"", "[1, \"1\", 1]", "[1, -1, 1]", "7"})
    expect_ignored(
        with_node_extras((R"({"clip_volume": {"name": "x", "half_size": )" + std::string(size) + "}}").c_str()),
        "/half_size: is not three numbers of metres above 0");
}

TEST(ClipVolume, ExtrasOfOthersAreLeftAlone) {
  for (const char* extras : {R"({"clip_volume": 7})", R"({"clip_volume": "hall"})", R"("text")", R"([1, 2])"})
    EXPECT_TRUE(read(with_node_extras(extras)).clip_volumes.empty()) << extras;
}

TEST(ClipVolume, NamesAreTheirOwn) {
  Model model = with_node_extras(R"({"clip_volume": {"name": "hall", "half_size": [1, 1, 1]}})");
  model.root["nodes"][0]["extras"] = model.root["nodes"][1]["extras"];
  const Scene scene = read(model);
  ASSERT_EQ(scene.clip_volumes.size(), 1u);
  EXPECT_EQ(scene.clip_volumes[0].node, 0u);
  EXPECT_TRUE(has_warning(scene, "/nodes/1/extras/clip_volume: has the name of an earlier volume; it is ignored"));
}

TEST(ClipVolume, LightsNameTheirs) {
  Model model = with_node_extras(R"({"clip_volume": {"name": "hall", "half_size": [1, 1, 1]}})");
  model.root["extensionsUsed"] = {"KHR_lights_punctual"};
  model.root["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::parse(R"([{"type": "point", "extras": {"clip_volume": "hall"}}, {"type": "point"},
                      {"type": "point", "extras": {"clip_volume": "moon"}},
                      {"type": "point", "extras": {"clip_volume": {"name": "hall"}}}])");
  const Scene scene = read(model);
  ASSERT_EQ(scene.lights.size(), 4u);
  EXPECT_EQ(scene.lights[0].clip_volume, 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(scene.lights[i].clip_volume, kNone) << i;
  EXPECT_TRUE(has_warning(
      scene,
      "/extensions/KHR_lights_punctual/lights/2/extras/clip_volume: is the name of no clip volume; it is ignored"));
}

}  // namespace
}  // namespace velarium::scene::test
