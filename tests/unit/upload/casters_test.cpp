#include "upload/casters.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace velarium::upload {
namespace {

scene::Primitive triangle(std::int32_t material) {
  scene::Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.indices = {0, 1, 2};
  p.material = material;
  p.bounds = {{0, 0, 0}, {1, 1, 0}};
  return p;
}

// An opaque and a cut-out primitive, and one of lines; an instance of each at x = 0, 10, 20, ...
struct Row {
  scene::Scene scene;
  scene::SceneSnapshot snapshot;

  Row() {
    scene.nodes.resize(1);
    scene.materials.resize(2);
    scene.materials[1].alpha_mode = scene::AlphaMode::mask;
    scene.primitives = {triangle(0), triangle(1), triangle(0)};
    scene.primitives[2].topology = scene::Topology::lines;
  }
  void add(std::uint32_t primitive) {
    const float x = 10.0f * static_cast<float>(snapshot.instances.size());
    snapshot.instances.push_back({.primitive = primitive,
                                  .world_from_object = glm::translate(glm::mat4(1.0f), {x, 0.0f, 0.0f}),
                                  .bounds = {{x, 0, 0}, {x + 1, 1, 0}}});
  }
};

// x < limit
std::vector<glm::dvec4> left_of(double limit) {
  return {{-1.0, 0.0, 0.0, limit}};
}

TEST(Casters, AreTrianglesOfEveryInstanceOpaqueOnesFirst) {
  Row row;
  for (const std::uint32_t primitive : {1u, 0u, 2u, 0u}) row.add(primitive);
  const auto table = make_casters(row.scene, row.snapshot, {0.0, 0.0, 1.0});
  ASSERT_EQ(table.casters.size(), 3u);
  EXPECT_EQ(table.casters[0].kind, CasterKind::opaque);
  EXPECT_EQ(table.casters[2].kind, CasterKind::cutout);
  // Opaque ones stand at x = 10 and 30, one metre before the eye.
  EXPECT_EQ(table.objects[0].world_from_object[0].w, 10.0f);
  EXPECT_EQ(table.objects[1].world_from_object[0].w, 30.0f);
  EXPECT_EQ(table.objects[0].world_from_object[2].w, -1.0f);
}

TEST(Casters, NeighboursOfOneStateAreOneDraw) {
  Row row;
  for (int i = 0; i < 4; ++i) row.add(0);
  const auto table = make_casters(row.scene, row.snapshot, {});
  const auto all = visible_casters(table, CasterKind::opaque, left_of(100.0));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].object_count, 4u);
  EXPECT_TRUE(visible_casters(table, CasterKind::cutout, left_of(100.0)).empty());
}

// What deforms, and what hangs on a node that is animated, may be elsewhere at another time.
TEST(Casters, ThatMoveAreLeftOutWhereStillOnesAreAskedFor) {
  Row row;
  row.scene.nodes.resize(2);
  row.scene.animations = {{.channels = {{.node = 1}}}};
  for (int i = 0; i < 3; ++i) row.add(0);
  row.snapshot.instances[0].deformed = 0;
  row.snapshot.deformed.resize(1);
  row.snapshot.instances[1].node = 1;
  const auto table = make_casters(row.scene, row.snapshot, {});
  // Both of those at rest in this snapshot are one draw, that which is deformed another.
  EXPECT_EQ(visible_casters(table, CasterKind::opaque, left_of(100.0)).size(), 2u);
  const auto still = visible_casters(table, CasterKind::opaque, left_of(100.0), CasterChoice::static_only);
  ASSERT_EQ(still.size(), 1u);
  EXPECT_EQ(still[0].object_count, 1u);
  EXPECT_EQ(bounds_of(table).min.x, 0.0f);
  EXPECT_EQ(bounds_of(table, CasterChoice::static_only).min.x, 20.0f);
  row.snapshot.instances[2].node = 1;
  EXPECT_TRUE(has_static(table));
  const auto all_moving = make_casters(row.scene, row.snapshot, {});
  EXPECT_TRUE(bounds_of(all_moving, CasterChoice::static_only).empty());
  EXPECT_FALSE(has_static(all_moving));
}

TEST(Casters, WhatTheVolumeDoesNotHoldIsNotDrawn) {
  Row row;
  for (int i = 0; i < 4; ++i) row.add(0);
  const auto table = make_casters(row.scene, row.snapshot, {});
  const auto left = visible_casters(table, CasterKind::opaque, left_of(15.0));
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].first_object, 0u);
  EXPECT_EQ(left[0].object_count, 2u);

  // A gap ends a draw.
  row.snapshot.instances[1].bounds = {{1000, 0, 0}, {1001, 1, 0}};
  const auto gap = visible_casters(make_casters(row.scene, row.snapshot, {}), CasterKind::opaque, left_of(100.0));
  ASSERT_EQ(gap.size(), 2u);
  EXPECT_EQ(gap[1].first_object, 2u);
  EXPECT_EQ(gap[1].object_count, 2u);
}

}  // namespace
}  // namespace velarium::upload
