#include "scene/tangents.hpp"

#include "expect_near.hpp"
#include "scene/mikktspace.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>

namespace velarium::scene {
namespace {

using test::expect_near;

constexpr float kRounding = 1e-6f;

// A square in the plane z = 0 that faces +Z, with uv as glTF images lie: u to the right, v down.
Primitive upright_square() {
  Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  p.vertices.normals.assign(4, {0, 0, 1});
  p.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  p.indices = {0, 1, 2, 0, 2, 3};
  return p;
}

TEST(Tangents, AnUprightPictureHasItsTangentToTheRightAndItsBitangentUp) {
  Primitive p = upright_square();
  make_tangents(p, 0);
  ASSERT_EQ(p.vertex_count(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec4 t = p.vertices.tangents[i];
    expect_near(glm::vec3(t), {1, 0, 0});
    expect_near(t.w * glm::cross(p.vertices.normals[i], glm::vec3(t)), {0, 1, 0});
  }
}

TEST(Tangents, ARotatedAndStretchedTextureTurnsTheTangent) {
  Primitive p = upright_square();
  const float angle = glm::radians(30.0f);
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec3 q = p.vertices.positions[i];
    p.uv[0][i] = {3.0f * (q.x * std::cos(angle) + q.y * std::sin(angle)),
                  -0.5f * (q.y * std::cos(angle) - q.x * std::sin(angle))};
  }
  make_tangents(p, 0);
  for (const glm::vec4& t : p.vertices.tangents) {
    expect_near(glm::vec3(t), {std::cos(angle), std::sin(angle), 0});
    EXPECT_EQ(t.w, 1.0f);
  }
}

// Texture mirrored about x = 1: the shared edge cannot have one frame for both sides.
TEST(Tangents, VerticesOnTheSeamOfAMirroredTextureAreSplitWithAllTheirAttributes) {
  Primitive p = upright_square();
  p.vertices.positions.insert(p.vertices.positions.end(), {{2, 0, 0}, {2, 1, 0}});
  p.vertices.normals.assign(6, {0, 0, 1});
  p.uv[0].insert(p.uv[0].end(), {{0, 1}, {0, 0}});
  p.indices.insert(p.indices.end(), {1, 4, 5, 1, 5, 2});
  p.colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}, {4, 0, 0, 1}, {5, 0, 0, 1}};
  p.skin_sets = 2;
  for (std::uint16_t set = 0; set < 2; ++set) {
    for (std::uint16_t v = 0; v < 6; ++v) p.joints.push_back(glm::u16vec4(10 * set + v));
  }
  p.weights.assign(12, glm::vec4(0.125f));
  p.morph_targets.resize(1);
  for (const glm::vec4& color : p.colors) p.morph_targets[0].positions.push_back(glm::vec3(color.x));
  const Primitive before = p;
  make_tangents(p, 0);
  ASSERT_EQ(p.vertex_count(), 8u);
  ASSERT_EQ(p.joints.size(), 16u);
  for (std::size_t corner = 0; corner < p.indices.size(); ++corner) {
    const std::uint32_t now = p.indices[corner], then = before.indices[corner];
    EXPECT_EQ(p.vertices.positions[now], before.vertices.positions[then]);
    EXPECT_EQ(p.uv[0][now], before.uv[0][then]);
    EXPECT_EQ(p.colors[now], before.colors[then]);
    EXPECT_EQ(p.morph_targets[0].positions[now], before.morph_targets[0].positions[then]);
    EXPECT_EQ(p.joints[now], before.joints[then]);
    EXPECT_EQ(p.joints[8 + now], before.joints[6 + then]);
    const bool mirrored = corner >= 6;
    expect_near(glm::vec3(p.vertices.tangents[now]), {mirrored ? -1.0f : 1.0f, 0, 0});
    EXPECT_EQ(p.vertices.tangents[now].w, mirrored ? -1.0f : 1.0f);
  }
}

// Two faces that meet at a vertex with corner angles 90 and 45 degrees: the average leans by their weights.
TEST(Tangents, FacesWeighByTheirCornerAngle) {
  Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
  p.vertices.normals.assign(4, {0, 0, 1});
  p.uv[0] = {{0, 0}, {1, 0}, {0, -1}, {-1, -2}};
  p.indices = {0, 1, 2, 0, 2, 3};
  make_tangents(p, 0);
  // Second face: position = a u + b v, where the edges give b = (0, -1) and -a - 2 b = (-1, 1): a = (1, 1).
  const glm::vec2 first(1, 0), second = glm::normalize(glm::vec2(1, 1));
  const glm::vec2 mean = glm::normalize(90.0f * first + 45.0f * second);
  ASSERT_EQ(p.vertex_count(), 4u);
  expect_near(glm::vec3(p.vertices.tangents[p.indices[0]]), glm::vec3(mean, 0));
  expect_near(glm::vec3(p.vertices.tangents[p.indices[1]]), glm::vec3(first, 0));
  expect_near(glm::vec3(p.vertices.tangents[p.indices[5]]), glm::vec3(second, 0));
}

// Four faces around a point, whose directions of u turn by 90 degrees from one to the next. The mean of all is nothing;
// the algorithm leaves the opposite face out of each average, and the two at right angles cancel.
TEST(Tangents, ExactlyOppositeDirectionsDoNotCancel) {
  const std::array<glm::vec3, 5> rim{{{1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}}};
  Primitive p;
  p.vertices.positions = {{0, 0, 0}};
  p.uv[0] = {{0.5f, 0}};
  for (std::uint32_t k = 0; k < 5; ++k) {
    p.vertices.positions.push_back(rim[k]);
    p.uv[0].push_back({0.25f * static_cast<float>(k), 1});
    if (k < 4) p.indices.insert(p.indices.end(), {0u, k + 1, k + 2});
  }
  p.vertices.normals.assign(6, {0, 0, 1});
  make_tangents(p, 0);
  for (std::size_t k = 0; k < 4; ++k) {
    expect_near(glm::vec3(p.vertices.tangents[p.indices[3 * k]]), glm::normalize(rim[k + 1] - rim[k]));
  }
}

// Three faces of 90 degrees around a point; the texture of the middle one has no area. The outer two, whose u runs
// along x and along y, are averaged across it, and it takes their frame.
TEST(Tangents, AFaceWithoutTextureAreaJoinsItsNeighbours) {
  Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  p.vertices.normals.assign(5, {0, 0, 1});
  p.uv[0] = {{0, 0}, {1, 0}, {0, 1}, {0, 2}, {-1, 0}};
  p.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4};
  make_tangents(p, 0);
  for (const std::size_t corner : {0u, 3u, 6u}) {
    const glm::vec4 t = p.vertices.tangents[p.indices[corner]];
    expect_near(glm::vec3(t), glm::normalize(glm::vec3(1, 1, 0)));
    EXPECT_EQ(t.w, -1.0f);
  }
}

TEST(Tangents, LieInThePlaneOfASlantedNormal) {
  Primitive p = upright_square();
  const glm::vec3 normal = glm::normalize(glm::vec3(1, 0, 1));
  p.vertices.normals.assign(4, normal);
  make_tangents(p, 0);
  for (const glm::vec4& t : p.vertices.tangents) expect_near(glm::vec3(t), glm::normalize(glm::vec3(1, 0, -1)));
}

TEST(Tangents, AreUnitAndInThePlaneEvenWhereTheTextureNamesNoDirection) {
  Primitive p = upright_square();
  p.uv[0].assign(4, {0.5f, 0.5f});
  for (const glm::vec3& normal : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
    Primitive q = p;
    q.vertices.normals.assign(4, normal);
    make_tangents(q, 0);
    for (const glm::vec4& t : q.vertices.tangents) {
      EXPECT_NEAR(glm::length(glm::vec3(t)), 1.0f, kRounding);
      EXPECT_NEAR(glm::dot(glm::vec3(t), normal), 0.0f, kRounding);
      EXPECT_EQ(std::abs(t.w), 1.0f);
    }
  }
}

TEST(Tangents, ATriangleWithoutAreaTakesItsNeighboursTangent) {
  Primitive p = upright_square();
  p.indices.insert(p.indices.end(), {1, 1, 2});
  make_tangents(p, 0);
  ASSERT_EQ(p.indices.size(), 9u);
  for (std::size_t corner = 6; corner < 9; ++corner) {
    expect_near(glm::vec3(p.vertices.tangents[p.indices[corner]]), {1, 0, 0});
  }
}

// Values of a hostile file, and fans that would take quadratic time if compared pair by pair.
TEST(Tangents, SurviveNonFiniteValuesAndHugeFans) {
  Primitive p = upright_square();
  p.vertices.positions[2].x = std::numeric_limits<float>::quiet_NaN();
  p.uv[0][1].x = std::numeric_limits<float>::infinity();
  make_tangents(p, 0);
  EXPECT_EQ(p.indices.size(), 6u);

  constexpr std::uint32_t kFaces = 100000;
  Primitive fan;
  fan.vertices.positions = {{0, 0, 0}};
  fan.uv[0] = {{0, 0}};
  for (std::uint32_t i = 0; i < kFaces; ++i) {
    const float angle = glm::radians(360.0f) * static_cast<float>(i) / kFaces;
    fan.vertices.positions.push_back({std::cos(angle), std::sin(angle), 0});
    fan.uv[0].push_back({static_cast<float>(i) / kFaces, 1});
    fan.indices.insert(fan.indices.end(), {0u, i + 1, (i + 1) % kFaces + 1});
  }
  fan.vertices.normals.assign(kFaces + 1, {0, 0, 1});
  make_tangents(fan, 0);
  EXPECT_EQ(fan.indices.size(), 3 * kFaces);
}

struct Reference {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> uv;
  std::vector<glm::vec4> tangents;
};

Reference read_reference() {
  std::ifstream file(std::filesystem::path(VELARIUM_TEST_DATA) / "mikktspace_reference.txt");
  Reference out;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream row(line);
    glm::vec3 p, n;
    glm::vec2 uv;
    glm::vec4 t;
    row >> p.x >> p.y >> p.z >> n.x >> n.y >> n.z >> uv.x >> uv.y >> t.x >> t.y >> t.z >> t.w;
    EXPECT_TRUE(row) << line;
    out.positions.push_back(p);
    out.normals.push_back(n);
    out.uv.push_back(uv);
    out.tangents.push_back(t);
  }
  return out;
}

// The reference's sign is for v upwards in the picture, glTF's v runs down: the signs are opposite.
TEST(Tangents, AgreeWithTheReferenceImplementation) {
  const Reference reference = read_reference();
  ASSERT_EQ(reference.positions.size(), 252u);
  std::vector<std::uint32_t> indices(reference.positions.size());
  std::iota(indices.begin(), indices.end(), 0u);
  const auto tangents = corner_tangents({reference.positions, reference.normals, reference.uv, indices});
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    // A few roundings: the last bits of acos and sqrt are the C library's.
    expect_near(glm::vec3(tangents[i]), glm::vec3(reference.tangents[i]), 1e-6f);
    EXPECT_EQ(tangents[i].w, -reference.tangents[i].w) << "corner " << i;
  }
}

TEST(FlatNormals, GiveEachTriangleItsOwnVerticesAndFaceNormal) {
  Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  p.uv[0] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  p.indices = {0, 1, 2, 0, 2, 3};
  make_flat_normals(p);
  ASSERT_EQ(p.vertex_count(), 6u);
  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(p.indices[i], i);
  for (std::size_t i = 0; i < 3; ++i) expect_near(p.vertices.normals[i], {0, 0, 1});
  for (std::size_t i = 3; i < 6; ++i) expect_near(p.vertices.normals[i], {1, 0, 0});
  EXPECT_EQ(p.uv[0][5], glm::vec2(1, 1));
}

TEST(FlatNormals, ServeTinyTrianglesAndThoseWithoutArea) {
  Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}, {1, 1, 1}};
  p.indices = {0, 1, 2, 3, 3, 0};
  make_flat_normals(p);
  expect_near(p.vertices.normals[0], {0, 0, 1});
  for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(glm::length(p.vertices.normals[i]), 1.0f, kRounding);
}

TEST(FlatNormals, OfMorphTargetsLeadToTheNormalOfTheMovedTriangle) {
  Primitive p;
  p.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.indices = {0, 1, 2};
  p.morph_targets.resize(1);
  p.morph_targets[0].positions = {{0, 0, 0}, {0, 0, 0}, {0, -1, 1}};  // the last corner moves to (0, 0, 1)
  make_flat_normals(p);
  ASSERT_EQ(p.morph_targets[0].normals.size(), 3u);
  expect_near(p.vertices.normals[0] + p.morph_targets[0].normals[0], {0, -1, 0});
}

}  // namespace
}  // namespace velarium::scene
