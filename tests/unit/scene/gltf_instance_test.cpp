// EXT_mesh_gpu_instancing: its table, and the instances of a snapshot.

#include "gltf_model.hpp"
#include "scene/snapshot.hpp"

#include <glm/geometric.hpp>

namespace velarium::scene::test {
namespace {

constexpr const char* kName = "EXT_mesh_gpu_instancing";
constexpr const char* kPlace = "/nodes/0/extensions/EXT_mesh_gpu_instancing";

Json& attributes(Model& model) {
  return model.root["nodes"][0]["extensions"][kName]["attributes"];
}

// The unit triangle three times: as it is, mirrored along X and moved, and turned by 90 degrees about Z.
Model instanced() {
  Model model = triangle();
  model.root["extensionsUsed"] = {kName};
  attributes(model)["TRANSLATION"] = model.add<float>("VEC3", kFloat, 3, {0, 0, 0, 10, 0, 0, 0, 5, 0});
  attributes(model)["ROTATION"] =
      model.add<std::int16_t>("VEC4", kShort, 3, {0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, 23170, 23170}, true);
  attributes(model)["SCALE"] = model.add<float>("VEC3", kFloat, 3, {1, 1, 1, -2, 1, 1, 1, 1, 1});
  return model;
}

void expect_box(const WorldAabb& box, const glm::dvec3& min, const glm::dvec3& max) {
  constexpr double kTolerance = 1e-4;  // sixteen bits of rotation
  EXPECT_LE(glm::length(box.min - min), kTolerance) << box.min.x << ' ' << box.min.y << ' ' << box.min.z;
  EXPECT_LE(glm::length(box.max - max), kTolerance) << box.max.x << ' ' << box.max.y << ' ' << box.max.z;
}

TEST(GltfInstancing, EachCopyStandsInTheSpaceOfItsNode) {
  Model model = instanced();
  model.root["nodes"][0]["translation"] = {0, 0, 3};
  const SceneSnapshot snapshot = snapshot_at(read(model), 0, "");
  ASSERT_EQ(snapshot.instances.size(), 3u);
  expect_box(snapshot.instances[0].bounds, {0, 0, 3}, {1, 1, 3});
  expect_box(snapshot.instances[1].bounds, {8, 0, 3}, {10, 1, 3});
  expect_box(snapshot.instances[2].bounds, {-1, 5, 3}, {0, 6, 3});
  EXPECT_FALSE(snapshot.instances[0].mirrored);
  EXPECT_TRUE(snapshot.instances[1].mirrored);
  EXPECT_FALSE(snapshot.instances[2].mirrored);
  expect_box(snapshot.bounds, {-1, 0, 3}, {10, 6, 3});
}

TEST(GltfInstancing, CopiesShareWhatDeformsThem) {
  Model model = instanced();
  const int lifted = model.add<float>("VEC3", kFloat, 3, {0, 0, 2, 0, 0, 2, 0, 0, 2});
  model.primitive()["targets"] = {{{"POSITION", lifted}}};
  model.root["meshes"][0]["weights"] = {1};
  const SceneSnapshot snapshot = snapshot_at(read(model), 0, "");
  ASSERT_EQ(snapshot.instances.size(), 3u);
  EXPECT_EQ(snapshot.deformed.size(), 1u);
  expect_box(snapshot.instances[1].bounds, {8, 0, 2}, {10, 1, 2});
}

TEST(GltfInstancing, ColumnsAreOptional) {
  Model model = instanced();
  attributes(model).erase("ROTATION");
  attributes(model).erase("SCALE");
  EXPECT_EQ(snapshot_at(read(model), 0, "").instances.size(), 3u);
  attributes(model).erase("TRANSLATION");
  attributes(model)["_ID"] = 0;
  const Scene scene = read(model);
  EXPECT_TRUE(has_warning(scene, "the mesh is drawn once"));
  EXPECT_EQ(snapshot_at(scene, 0, "").instances.size(), 1u);
}

TEST(GltfInstancing, ColumnsAreChecked) {
  Model model = instanced();
  attributes(model)["SCALE"] = model.add<float>("VEC3", kFloat, 2, {1, 1, 1, 1, 1, 1});
  expect_refused(model, std::string(kPlace) + "/attributes/SCALE: has 2 elements, but there are 3 instances");
  model = instanced();
  attributes(model)["TRANSLATION"] = attributes(model)["ROTATION"];
  expect_refused(model, std::string(kPlace) + "/attributes/TRANSLATION: is an accessor of VEC4 SHORT normalized");
  model = instanced();
  attributes(model)["ROTATION"] = model.add<float>("VEC4", kFloat, 3, std::vector<float>(12, 0.0f));
  expect_refused(model, std::string(kPlace) + "/attributes/ROTATION: a rotation is a quaternion of length 0");
  model = instanced();
  attributes(model)["_ID"] = 99;
  expect_refused(model, std::string(kPlace) + "/attributes/_ID: ");
}

TEST(GltfInstancing, WithoutAMeshOrWithASkinItIsIgnored) {
  Model model = instanced();
  model.root["nodes"][0].erase("mesh");
  EXPECT_TRUE(has_warning(read(model), "a node without a mesh, or with a skin"));
}

// A million copies in a file of a few hundred bytes are refused before there is memory for them.
TEST(GltfInstancing, CopiesCountAgainstTheLimitOfTheScene) {
  Model model = instanced();
  attributes(model).erase("ROTATION");
  attributes(model).erase("SCALE");
  Json& accessor = model.root["accessors"][attributes(model)["TRANSLATION"].get<int>()];
  accessor.erase("bufferView");
  accessor["count"] = 1000000;
  GltfOptions options;
  options.limits.elements = 5000000;
  expect_refused(model, std::string(kPlace) + ": with it, the scene has ", options);
}

}  // namespace
}  // namespace velarium::scene::test
