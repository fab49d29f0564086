#include "scene/snapshot.hpp"

#include "expect_near.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace velarium::scene {
namespace {

using test::expect_near;

constexpr float kRounding = 1e-5f;

// One triangle in the plane z = 0, with normals and tangents.
Primitive triangle() {
  Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.vertices.normals.assign(3, {0, 0, 1});
  p.vertices.tangents.assign(3, {1, 0, 0, 1});
  p.indices = {0, 1, 2};
  p.bounds = {{0, 0, 0}, {1, 1, 0}};
  return p;
}

// A parent with a child; the child draws the triangle.
Scene family() {
  Scene scene;
  scene.primitives.push_back(triangle());
  scene.meshes.push_back({"triangle", {0}, {}});
  scene.nodes.resize(2);
  scene.nodes[0].children = {1};
  scene.nodes[1].parent = 0;
  scene.nodes[1].mesh = 0;
  scene.roots = {0};
  return scene;
}

const VertexFrames& deformed(const SceneSnapshot& snapshot) {
  return snapshot.deformed.at(static_cast<std::size_t>(snapshot.instances.at(0).deformed));
}

// Of a skinned instance, in world space.
VertexFrames in_world(const SceneSnapshot& snapshot) {
  VertexFrames frames = deformed(snapshot);
  for (glm::vec3& p : frames.positions) p += glm::vec3(snapshot.instances.at(0).world_from_object[3]);
  return frames;
}

TEST(MovingNodes, AreThoseThatAnimationsMoveAndWhatHangsOnThem) {
  Scene scene = family();
  scene.nodes.resize(3);  // the third stands apart
  EXPECT_EQ(dynamic_nodes(scene), (std::vector<bool>{false, false, false}));
  scene.animations = {{}, {.channels = {{.node = 1}}}};
  EXPECT_EQ(dynamic_nodes(scene), (std::vector<bool>{false, true, false}));
  scene.animations[0].channels = {{.node = 0}};
  EXPECT_EQ(dynamic_nodes(scene), (std::vector<bool>{true, true, false}));
}

TEST(Aabb, TransformedBoundsTheTransformedCorners) {
  const Aabb box{{-1, 0, 2}, {1, 3, 5}};
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(90.0), glm::dvec3(0, 0, 1));
  const WorldAabb out = transformed(box, glm::translate(glm::dmat4(1), glm::dvec3(10, 0, 0)) * turn);
  expect_near(out.min, {7, -1, 2});  // x' = 10 - y, y' = x
  expect_near(out.max, {10, 1, 5});
  EXPECT_TRUE(transformed(Aabb{}, turn).empty());
}

TEST(Aabb, GrowsByPointsAndBoxesAndIgnoresEmptyOnes) {
  Aabb box;
  EXPECT_TRUE(box.empty());
  box.add(glm::vec3(1, 2, 3));
  box.add(Aabb{});
  EXPECT_EQ(box.min, glm::vec3(1, 2, 3));
  box.add(Aabb{{-1, -1, -1}, {0, 0, 0}});
  EXPECT_EQ(box.min, glm::vec3(-1));
  EXPECT_EQ(box.max, glm::vec3(1, 2, 3));
}

TEST(SceneSnapshot, MultipliesParentsAndScalesBeforeTurningBeforeMoving) {
  Scene scene = family();
  scene.nodes[0].translation = {10, 0, 0};
  scene.nodes[0].rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 0, 1));
  scene.nodes[1].scale = {2, 3, 4};
  scene.nodes[1].translation = {0, 5, 0};
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  ASSERT_EQ(snapshot.instances.size(), 1u);
  const Instance& instance = snapshot.instances[0];
  // (1,1,1) -> scaled (2,3,4) -> moved (2,8,4) -> turned (-8,2,4) -> moved (2,2,4)
  expect_near(glm::vec3(instance.world_from_object * glm::dvec4(1, 1, 1, 1)), {2, 2, 4});
  EXPECT_EQ(instance.deformed, kNone);
  EXPECT_EQ(instance.node, 1u);
  EXPECT_FALSE(instance.mirrored);
  expect_near(instance.bounds.min, {2, 0, 0});
  expect_near(instance.bounds.max, {5, 2, 0});
  expect_near(snapshot.bounds.min, instance.bounds.min);
}

TEST(SceneSnapshot, UsesAMatrixAsItIs) {
  Scene scene = family();
  scene.nodes[1].matrix = glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3));
  scene.nodes[1].translation = {100, 0, 0};
  expect_near(glm::vec3(snapshot_at(scene, 0, "").instances[0].world_from_object[3]), {1, 2, 3});
}

TEST(SceneSnapshot, KnowsMirroredInstances) {
  Scene scene = family();
  scene.nodes[0].scale = {-1, 1, 1};
  EXPECT_TRUE(snapshot_at(scene, 0, "").instances[0].mirrored);
  scene.nodes[1].scale = {1, 1, -2};
  EXPECT_FALSE(snapshot_at(scene, 0, "").instances[0].mirrored);
}

TEST(SceneSnapshot, DrawsOnlyTheShownSceneInNodeOrder) {
  Scene scene = family();
  scene.nodes.resize(5);
  for (Node& node : scene.nodes) node.mesh = 0;
  scene.roots = {3, 0};
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  ASSERT_EQ(snapshot.instances.size(), 3u);
  EXPECT_EQ(snapshot.instances[0].node, 0u);
  EXPECT_EQ(snapshot.instances[1].node, 1u);
  EXPECT_EQ(snapshot.instances[2].node, 3u);
}

TEST(SceneSnapshot, OfNothingIsEmpty) {
  const SceneSnapshot snapshot = snapshot_at(Scene{}, 0, "");
  EXPECT_TRUE(snapshot.bounds.empty());
  EXPECT_TRUE(snapshot.instances.empty());
}

TEST(SceneSnapshot, MovesAnimatedNodesWithTheirChildren) {
  Scene scene = family();
  const AnimationSampler s{Interpolation::linear, {0, 2}, {0, 0, 0, 8, 0, 0}, 3};
  scene.animations.push_back({"a", {s}, {{0, 0, AnimatedPath::translation}}, 2});
  expect_near(glm::vec3(snapshot_at(scene, 0.5f, "a").instances[0].world_from_object[3]), {2, 0, 0});
}

TEST(SceneSnapshot, MorphsBeforeTheNodeTransform) {
  Scene scene = family();
  scene.nodes[1].translation = {0, 0, 5};
  scene.nodes[1].weights = {0.5f, 2.0f};
  auto& targets = scene.primitives[0].morph_targets;
  targets.resize(3);  // the third has no weight
  targets[0].positions.assign(3, {0, 0, 4});
  targets[1].normals.assign(3, {0, 0.5f, 0});
  targets[2].positions.assign(3, {1e9f, 0, 0});
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  const VertexFrames v = deformed(snapshot);
  expect_near(v.positions[1], {1, 0, 2});
  expect_near(v.normals[1], glm::normalize(glm::vec3(0, 1, 1)));
  expect_near(glm::vec3(v.tangents[1]), {1, 0, 0});
  expect_near(glm::vec3(snapshot.instances[0].world_from_object[3]), {0, 0, 5});
  expect_near(snapshot.bounds.min, {0, 0, 7});
  expect_near(snapshot.bounds.max, {1, 1, 7});
}

TEST(SceneSnapshot, MorphedTangentsStayInThePlaneOfTheMorphedNormal) {
  Scene scene = family();
  scene.nodes[1].weights = {1};
  scene.primitives[0].morph_targets.resize(1);
  scene.primitives[0].morph_targets[0].normals.assign(3, {1, 0, 0});
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  expect_near(glm::vec3(deformed(snapshot).tangents[0]), glm::normalize(glm::vec3(1, 0, -1)));
}

// Two joints; the triangle's three corners hang on the first, the second, and half on each.
Scene skinned() {
  Scene scene = family();
  scene.nodes.resize(4);  // 2 and 3: joints
  scene.roots = {0, 2, 3};
  scene.nodes[1].skin = 0;
  scene.nodes[1].translation = {1000, 1000, 1000};  // has no part in a skinned mesh
  scene.skins.push_back({"skin", {2, 3}, {glm::mat4(1), glm::mat4(1)}});
  Primitive& p = scene.primitives[0];
  p.skin_sets = 1;
  p.joints = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}};
  p.weights = {{1, 0, 0, 0}, {1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}};
  return scene;
}

TEST(SceneSnapshot, SkinsBringVerticesToWorldSpace) {
  Scene scene = skinned();
  scene.nodes[2].translation = {0, 0, 2};
  scene.nodes[3].translation = {0, 0, 6};
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  // Whatever the node says, the instance stands at its skin's first joint and is turned as the world is.
  EXPECT_EQ(snapshot.instances[0].world_from_object, glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 2)));
  const VertexFrames v = in_world(snapshot);
  expect_near(v.positions[0], {0, 0, 2});
  expect_near(v.positions[1], {1, 0, 6});
  expect_near(v.positions[2], {0, 1, 4});
  expect_near(snapshot.bounds.min, {0, 0, 2});
  expect_near(snapshot.bounds.max, {1, 1, 6});
}

// On a planet's surface: a float holds half a metre there.
constexpr double kEarthRadius = 6378137.0;

TEST(SceneSnapshot, FarFromTheOriginNothingIsRounded) {
  for (const bool with_skin : {false, true}) {
    Scene near = with_skin ? skinned() : family(), far = near;
    const std::uint32_t moved = with_skin ? 2 : 0;
    far.nodes[moved].translation = {kEarthRadius, -kEarthRadius, 0.7};
    if (with_skin) far.nodes[3].translation = far.nodes[2].translation;
    const SceneSnapshot a = snapshot_at(near, 0, ""), b = snapshot_at(far, 0, "");
    EXPECT_LE(glm::length(b.bounds.min - a.bounds.min - far.nodes[moved].translation), 1e-8);
    EXPECT_LE(glm::length(b.bounds.max - a.bounds.max - far.nodes[moved].translation), 1e-8);
    if (with_skin) { EXPECT_EQ(deformed(a).positions, deformed(b).positions); }
  }
}

TEST(SceneSnapshot, BoundsAreThoseOfVerticesAndNotOfBoxes) {
  Scene scene = family();
  const SceneSnapshot straight = snapshot_at(scene, 0, "");
  const glm::quat turn = glm::angleAxis(glm::radians(45.0f), glm::vec3(0, 1, 0));
  scene.nodes[1].rotation = turn;
  for (glm::vec3& p : scene.primitives[0].vertices.positions) p = glm::inverse(turn) * p;
  Aabb& box = scene.primitives[0].bounds;
  box = {};
  for (const glm::vec3& p : scene.primitives[0].vertices.positions) box.add(p);
  const SceneSnapshot turned = snapshot_at(scene, 0, "");
  EXPECT_LE(glm::length(turned.bounds.min - straight.bounds.min), 1e-6);
  EXPECT_LE(glm::length(turned.bounds.max - straight.bounds.max), 1e-6);
}

TEST(SceneSnapshot, WhatIsScaledToNothingHasNoExtent) {
  Scene scene = family();
  scene.nodes[0].translation = {500, 0, 0};
  scene.nodes[0].scale = {0, 0, 0};
  EXPECT_TRUE(snapshot_at(scene, 0, "").bounds.empty());
  scene.nodes[0].scale = {0, 0, 1};  // a triangle becomes a line
  EXPECT_TRUE(snapshot_at(scene, 0, "").bounds.empty());
  scene.nodes[0].scale = {1, 1, 0};
  EXPECT_FALSE(snapshot_at(scene, 0, "").bounds.empty());
}

TEST(SceneSnapshot, SkinsAtTheBindPoseChangeNothing) {
  Scene scene = skinned();
  for (const std::uint32_t joint : {2u, 3u}) {
    scene.nodes[joint].translation = {1, 2, static_cast<float>(joint)};
    scene.nodes[joint].rotation = glm::angleAxis(0.3f * static_cast<float>(joint), glm::vec3(0, 1, 0));
    const glm::mat4 world = glm::translate(glm::mat4(1), glm::vec3(scene.nodes[joint].translation)) *
                            glm::mat4_cast(scene.nodes[joint].rotation);
    scene.skins[0].joint_from_object[joint - 2] = glm::inverse(world);
  }
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  for (std::size_t i = 0; i < 3; ++i) {
    expect_near(in_world(snapshot).positions[i], scene.primitives[0].vertices.positions[i]);
    expect_near(in_world(snapshot).normals[i], {0, 0, 1});
  }
}

TEST(SceneSnapshot, SkinsReadAllSetsOfJoints) {
  Scene scene = skinned();
  Primitive& p = scene.primitives[0];
  p.skin_sets = 2;
  p.joints.insert(p.joints.end(), 3, {1, 1, 1, 1});
  for (glm::vec4& w : p.weights) w *= 0.25f;
  p.weights.insert(p.weights.end(), 3, {0, 0, 0, 0.75f});
  scene.nodes[3].translation = {0, 0, 4};
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  expect_near(in_world(snapshot).positions[0], {0, 0, 3});
  expect_near(in_world(snapshot).positions[1], {1, 0, 4});
  expect_near(in_world(snapshot).positions[2], {0, 1, 3.5f});
}

// A surface tilted by 45 degrees, stretched along x by 2: its normal follows the inverse transpose.
TEST(SceneSnapshot, SkinnedNormalsStayPerpendicularUnderNonUniformScale) {
  Scene scene = skinned();
  scene.primitives[0].vertices.normals.assign(3, glm::normalize(glm::vec3(1, 0, 1)));
  scene.primitives[0].vertices.tangents.assign(3, glm::vec4(glm::normalize(glm::vec3(1, 0, -1)), 1));
  for (const std::uint32_t joint : {2u, 3u}) scene.nodes[joint].scale = {2, 1, 1};
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  for (std::size_t i = 0; i < 3; ++i) {
    expect_near(in_world(snapshot).normals[i], glm::normalize(glm::vec3(1, 0, 2)));
    expect_near(glm::vec3(in_world(snapshot).tangents[i]), glm::normalize(glm::vec3(2, 0, -1)));
  }
}

// Mirrored in x: a normal along z and the bitangent's direction in space stay as they are.
TEST(SceneSnapshot, MirroringJointsKeepNormalsOutAndTurnTheFrame) {
  Scene scene = skinned();
  for (const std::uint32_t joint : {2u, 3u}) scene.nodes[joint].scale = {-1, 1, 1};
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  EXPECT_TRUE(snapshot.instances[0].mirrored);
  const glm::vec3 n = in_world(snapshot).normals[0];
  const glm::vec4 t = in_world(snapshot).tangents[0];
  expect_near(n, {0, 0, 1});
  expect_near(glm::vec3(t), {-1, 0, 0});
  expect_near(t.w * glm::cross(n, glm::vec3(t)), {0, 1, 0});
}

TEST(SceneSnapshot, DeformsMeshesOfManyRangesWhole) {
  constexpr std::size_t kCount = 10001;
  Scene scene = family();
  Primitive& p = scene.primitives[0];
  p.vertices = {};
  for (std::size_t i = 0; i < kCount; ++i) p.vertices.positions.push_back(glm::vec3(static_cast<float>(i)));
  p.topology = Topology::points;
  p.morph_targets.resize(1);
  p.morph_targets[0].positions.assign(kCount, {0, 1, 0});
  scene.nodes[1].weights = {1};
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  ASSERT_EQ(in_world(snapshot).positions.size(), kCount);
  EXPECT_TRUE(in_world(snapshot).normals.empty());
  for (std::size_t i = 0; i < kCount; ++i) {
    const float x = static_cast<float>(i);
    ASSERT_EQ(in_world(snapshot).positions[i], glm::vec3(x, x + 1, x));
  }
}

TEST(SceneSnapshot, LightsShineAlongMinusZOfTheirNode) {
  Scene scene = family();
  scene.lights.resize(1);
  scene.nodes[1].name = "lamp";
  scene.nodes[1].light = 0;
  scene.nodes[0].translation = {1, 2, 3};
  scene.nodes[0].scale = glm::vec3(7);
  scene.nodes[1].rotation = glm::angleAxis(glm::radians(-90.0f), glm::vec3(1, 0, 0));
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  ASSERT_EQ(snapshot.lights.size(), 1u);
  expect_near(snapshot.lights[0].position, {1, 2, 3});
  expect_near(snapshot.lights[0].direction, {0, -1, 0});
  EXPECT_EQ(snapshot.lights[0].light.name, "lamp");
}

TEST(SceneSnapshot, CamerasAreRigidWhateverTheScale) {
  Scene scene = family();
  scene.cameras.resize(1);
  scene.nodes[1].camera = 0;
  scene.nodes[1].translation = {1, 0, 0};
  scene.nodes[1].rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 1, 0));  // looks along -X
  for (const glm::vec3& scale : {glm::vec3(3, 3, 3), glm::vec3(1, 2, 5), glm::vec3(-2, 1, 1)}) {
    scene.nodes[0].scale = scale;
    const glm::mat4 m = snapshot_at(scene, 0, "").cameras.at(0).world_from_view;
    expect_near(glm::vec3(m * glm::vec4(0, 0, -1, 0)), {scale.x > 0 ? -1.0f : 1.0f, 0, 0});
    expect_near(glm::vec3(m[1]), {0, 1, 0});
    EXPECT_NEAR(glm::determinant(m), 1.0f, kRounding);
    expect_near(glm::vec3(m[3]), {scale.x, 0, 0});
  }
  scene.nodes[0].scale = glm::vec3(0);
  EXPECT_NEAR(glm::determinant(snapshot_at(scene, 0, "").cameras.at(0).world_from_view), 1.0f, kRounding);
}

}  // namespace
}  // namespace velarium::scene
