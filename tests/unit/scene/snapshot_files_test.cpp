// Moments of the files in tests/data, against what the files were made to show.

#include "expect_near.hpp"
#include "scene/gltf.hpp"
#include "scene/snapshot.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace velarium::scene {
namespace {

using test::expect_near;

Scene test_scene(const char* name) {
  return read_gltf(std::filesystem::path(VELARIUM_TEST_DATA) / name);
}

// Three joints a metre apart, the upper two turned by the same angle: the top stands at the end of three unit steps.
TEST(MomentOfFile, TheSkinnedBarCurlsAsItsJointsTurn) {
  const Scene scene = test_scene("skinned_bar.gltf");
  for (const auto& [time, degrees] : {std::pair{0.0f, -35.0f}, std::pair{0.5f, 0.0f}, std::pair{1.0f, 35.0f}}) {
    const SceneSnapshot snapshot = snapshot_at(scene, time, "curl");
    const VertexFrames& bar = snapshot.deformed.at(0);
    const VertexFrames& rest = scene.primitives[snapshot.instances.at(0).primitive].vertices;
    glm::vec3 top(0.0f);
    float count = 0;
    for (std::size_t i = 0; i < rest.positions.size(); ++i) {
      if (rest.positions[i].y < 2.99f) continue;
      top += bar.positions[i];
      ++count;
    }
    const float a = glm::radians(degrees);
    expect_near(top / count, {-std::sin(a) - std::sin(2 * a), 1 + std::cos(a) + std::cos(2 * a), 0});
  }
}

// At one second the first target alone is applied: the top is sheared by 0.3 m, the bottom by as much to the left.
TEST(MomentOfFile, TheMorphedCubeShears) {
  const SceneSnapshot snapshot = snapshot_at(test_scene("morph_cube.gltf"), 1.0f, "breathe");
  expect_near(snapshot.bounds.min, {-0.8f, -0.5f, -0.5f});
  expect_near(snapshot.bounds.max, {0.8f, 0.5f, 0.5f});
}

TEST(MomentOfFile, NegativeScaleMirrorsHalfOfTheStairs) {
  const SceneSnapshot snapshot = snapshot_at(test_scene("mirrored_and_masked.gltf"), 0, "");
  std::size_t mirrored = 0;
  for (const Instance& instance : snapshot.instances) mirrored += instance.mirrored ? 1 : 0;
  EXPECT_EQ(mirrored, 3u);
  EXPECT_EQ(snapshot.instances.size(), 8u);  // ground, twice three steps, screen
}

TEST(MomentOfFile, LightsPointWhereTheyWerePlaced) {
  const SceneSnapshot snapshot = snapshot_at(test_scene("lights.gltf"), 0, "");
  ASSERT_EQ(snapshot.lights.size(), 3u);
  expect_near(snapshot.lights[0].direction, glm::normalize(glm::vec3(2, -3, -2)));
  expect_near(snapshot.lights[1].position, {-0.6f, 0.9f, 1.0f});
  const float a = glm::radians(85.0f);
  expect_near(snapshot.lights[2].direction, {0, -std::sin(a), -std::cos(a)});
}

// Quantized to steps of 1 / 16000, the knot keeps its shape: its tube of radius 0.13 about a curve within 0.77.
TEST(MomentOfFile, QuantizedPositionsAreScaledBack) {
  const SceneSnapshot snapshot = snapshot_at(test_scene("quantized.gltf"), 0, "");
  EXPECT_GT(snapshot.bounds.max.x, 0.85f);
  EXPECT_LT(snapshot.bounds.max.x, 0.90f + 1e-4f);
  EXPECT_NEAR(snapshot.bounds.max.z, 0.28f + 0.13f, 0.02f);
}

TEST(MomentOfFile, EveryFileHasItsCameraAndSomethingToSee) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VELARIUM_TEST_DATA)) {
    if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") continue;
    ++files;
    const SceneSnapshot snapshot = snapshot_at(read_gltf(entry.path()), 0, "");
    EXPECT_EQ(snapshot.cameras.size(), 1u) << entry.path();
    EXPECT_FALSE(snapshot.bounds.empty()) << entry.path();
  }
  EXPECT_GE(files, 18u);
}

}  // namespace
}  // namespace velarium::scene
