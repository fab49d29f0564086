#include "upload/draws.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>

namespace velarium::upload {
namespace {

// Everything is inside: planes far out, facing in.
Frustum everything() {
  Frustum frustum;
  frustum.fill(glm::dvec4(0.0, 0.0, 0.0, 1.0));
  return frustum;
}

class Draws : public ::testing::Test {
 protected:
  Draws() {
    scene_.materials.resize(3);
    scene_.materials[kGlass].alpha_mode = scene::AlphaMode::blend;
    scene_.materials[kDoubleGlass].alpha_mode = scene::AlphaMode::blend;
    scene_.materials[kDoubleGlass].double_sided = true;
    for (std::int32_t material = 0; material < 3; ++material) {
      scene::Primitive primitive;
      primitive.material = material;
      scene_.primitives.push_back(primitive);
    }
  }

  // A unit cube around `place`.
  void add(std::uint32_t primitive, const glm::vec3& place) {
    scene::Instance instance;
    instance.primitive = primitive;
    instance.world_from_object = glm::translate(glm::mat4(1.0f), place);
    instance.bounds = {place - 0.5f, place + 0.5f};
    snapshot_.instances.push_back(instance);
  }
  [[nodiscard]] DrawList list(const Frustum& frustum = everything()) const {
    return make_draw_list(scene_, snapshot_, glm::dvec3(0.0), frustum, Viewpoint{}, sorted_triangles_);
  }

  static constexpr std::uint32_t kSolid = 0, kGlass = 1, kDoubleGlass = 2;
  scene::Scene scene_;
  scene::SceneSnapshot snapshot_;
  std::size_t sorted_triangles_ = 1000;
};

TEST_F(Draws, ManyInstancesOfOneMeshAreOneDraw) {
  for (int i = 0; i < 4096; ++i) add(kSolid, {static_cast<float>(i % 64), 0.0f, static_cast<float>(i / 64)});
  const DrawList list = this->list();
  ASSERT_EQ(list.opaque.size(), 1u);
  EXPECT_EQ(list.opaque[0].object_count, 4096u);
  EXPECT_EQ(list.objects.size(), 4096u);
}

TEST_F(Draws, MirroredAndDeformedInstancesAreDrawnApart) {
  for (int i = 0; i < 4; ++i) add(kSolid, {static_cast<float>(i), 0.0f, 0.0f});
  snapshot_.instances[1].mirrored = true;
  snapshot_.instances[2].deformed = 0;
  const DrawList list = this->list();
  ASSERT_EQ(list.opaque.size(), 3u);
  EXPECT_EQ(list.opaque[0].object_count, 2u);
}

TEST_F(Draws, BlendedNeighboursOfOneStateAreOneDrawFarToNear) {
  for (int i = 0; i < 100; ++i) add(kGlass, {0.0f, 0.0f, -static_cast<float>(i)});
  const DrawList list = this->list();
  ASSERT_EQ(list.blended.size(), 1u);
  EXPECT_EQ(list.blended[0].object_count, 100u);
  EXPECT_TRUE(std::is_sorted(list.objects.begin(), list.objects.end(), [](const ObjectData& a, const ObjectData& b) {
    return a.world_from_object[2].w < b.world_from_object[2].w;
  }));
  EXPECT_EQ(list.objects.front().world_from_object[2].w, -99.0f);
}

TEST_F(Draws, DoubleSidedBlendedSurfacesAreDrawnOneByOne) {
  for (int i = 0; i < 5; ++i) add(kDoubleGlass, {0.0f, 0.0f, -static_cast<float>(i)});
  EXPECT_EQ(list().blended.size(), 5u);
}

TEST_F(Draws, BlendedSurfacesAreNotReorderedToJoin) {
  add(kGlass, {0.0f, 0.0f, -1.0f});
  add(kDoubleGlass, {0.0f, 0.0f, -2.0f});
  add(kGlass, {0.0f, 0.0f, -3.0f});
  const DrawList list = this->list();
  ASSERT_EQ(list.blended.size(), 3u);
  EXPECT_EQ(list.blended[0].primitive, kGlass);
  EXPECT_EQ(list.blended[1].primitive, kDoubleGlass);
}

// Three triangles, at these distances from the eye.
scene::Primitive three_triangles(std::int32_t material, const std::array<float, 3>& distances) {
  scene::Primitive primitive;
  primitive.material = material;
  for (const float z : distances)
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}) {
      primitive.indices.push_back(static_cast<std::uint32_t>(primitive.indices.size()));
      primitive.vertices.positions.emplace_back(corner.x, corner.y, -z);
    }
  return primitive;
}

TEST_F(Draws, TrianglesOfBlendedSurfacesAreDrawnFarToNear) {
  scene_.primitives.push_back(three_triangles(kDoubleGlass, {1, 3, 2}));
  add(3, {0.0f, 0.0f, 0.0f});
  add(3, {0.0f, 0.0f, -5.0f});
  const DrawList list = this->list();
  ASSERT_EQ(list.blended.size(), 2u);
  ASSERT_EQ(list.sorted_indices.size(), 18u);
  for (const auto& draw : list.blended) {
    const auto* sorted = &list.sorted_indices[static_cast<std::size_t>(draw.first_sorted)];
    EXPECT_EQ(std::vector(sorted, sorted + 9), (std::vector<std::uint32_t>{3, 4, 5, 6, 7, 8, 0, 1, 2}));
  }
}

TEST_F(Draws, TheNearestAreSortedWhereThereAreTooMany) {
  scene_.primitives.push_back(three_triangles(kGlass, {1, 3, 2}));
  for (const float z : {-9.0f, -1.0f, -5.0f, -7.0f}) add(3, {0.0f, 0.0f, z});
  sorted_triangles_ = 7;
  const DrawList list = this->list();
  ASSERT_EQ(list.blended.size(), 3u);  // of the unsorted ones one
  EXPECT_EQ(list.blended[0].object_count, 2u);
  EXPECT_EQ(list.blended[0].first_sorted, scene::kNone);
  EXPECT_NE(list.blended[1].first_sorted, scene::kNone);
  EXPECT_NE(list.blended[2].first_sorted, list.blended[1].first_sorted);
  EXPECT_EQ(list.sorted_indices.size(), 18u);
}

TEST_F(Draws, OpaqueSurfacesAreNotSorted) {
  scene_.primitives.push_back(three_triangles(kSolid, {1, 3, 2}));
  add(3, {0.0f, 0.0f, 0.0f});
  EXPECT_TRUE(list().sorted_indices.empty());
}

TEST_F(Draws, WhatTheFrustumMissesIsNotDrawn) {
  for (const float x : {-10.0f, 0.2f, 10.0f}) add(kSolid, {x, 0.0f, 0.0f});
  Frustum frustum = everything();
  frustum[0] = glm::dvec4(1.0, 0.0, 0.0, 0.0);   // x >= 0
  frustum[1] = glm::dvec4(-1.0, 0.0, 0.0, 5.0);  // x <= 5
  const DrawList list = this->list(frustum);
  ASSERT_EQ(list.objects.size(), 1u);
  EXPECT_FLOAT_EQ(list.objects[0].world_from_object[0].w, 0.2f);
}

TEST_F(Draws, StatesStandWhereTheirNearestInstanceDoes) {
  scene_.primitives.push_back({});
  scene_.primitives.back().material = 0;
  add(kSolid, {0.0f, 0.0f, -9.0f});
  add(3, {0.0f, 0.0f, -5.0f});
  add(kSolid, {0.0f, 0.0f, -1.0f});
  const DrawList list = this->list();
  ASSERT_EQ(list.opaque.size(), 2u);
  EXPECT_EQ(list.opaque[0].primitive, kSolid);
  EXPECT_EQ(list.opaque[0].object_count, 2u);
}

}  // namespace
}  // namespace velarium::upload
