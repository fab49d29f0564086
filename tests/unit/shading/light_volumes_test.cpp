#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

// A picture of 3:2 with 60 degrees of height, its axis off the middle.
constexpr vec4 kNdcToView{0.866f, -0.577f, 0.02f, 0.01f};

vec2 ndc_of(const vec3& point_vs, float perspective) {
  const vec2 lateral(point_vs.x, point_vs.y);
  const vec2 at_one = perspective > 0.5f ? lateral / -point_vs.z : lateral;
  return (at_one - vec2(kNdcToView.z, kNdcToView.w)) / vec2(kNdcToView.x, kNdcToView.y);
}

// The sphere's points on the screen, cut at its edges.
ScreenBounds bounds_of_points(const vec3& center, float radius, float perspective) {
  constexpr int kSteps = 600;
  ScreenBounds b{vec2(1.0f), vec2(-1.0f)};
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double polar = kPiExact * i / kSteps, azimuth = 2.0 * kPiExact * j / kSteps;
      const vec3 direction(
          glm::dvec3(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)));
      const vec2 ndc = clamp(ndc_of(center + radius * direction, perspective), -1.0f, 1.0f);
      b.low = min(b.low, ndc);
      b.high = max(b.high, ndc);
    }
  return b;
}

TEST(LightVolumes, ScreenBoundsAreThoseOfTheSphere) {
  Random random(7);
  for (const float perspective : {1.0f, 0.0f})
    for (int i = 0; i < 6; ++i) {
      const float depth = random.uniform(0.5f, 6.0f), radius = 0.95f * depth * random.uniform();
      const vec3 center(random.uniform(-2.0f, 2.0f), random.uniform(-2.0f, 2.0f), -depth);
      const ScreenBounds expected = bounds_of_points(center, radius, perspective);
      const ScreenBounds actual = sphere_screen_bounds(center, radius, kNdcToView, perspective);
      for (int axis = 0; axis < 2; ++axis) {
        EXPECT_LE(actual.low[axis], expected.low[axis]);
        EXPECT_GE(actual.high[axis], expected.high[axis]);
        EXPECT_NEAR(actual.low[axis], expected.low[axis], 2e-3f);
        EXPECT_NEAR(actual.high[axis], expected.high[axis], 2e-3f);
      }
    }
}

TEST(LightVolumes, SpheresThatReachTheEyeCoverAll) {
  EXPECT_EQ(screen_share(sphere_screen_bounds(vec3(0.0f, 0.0f, -1.0f), 1.0f, kNdcToView, 1.0f)), 1.0f);
  EXPECT_EQ(screen_share(sphere_screen_bounds(vec3(3.0f, 1.0f, 2.0f), 4.0f, kNdcToView, 1.0f)), 1.0f);
}

TEST(LightVolumes, SpheresOutsideTheViewCoverNothing) {
  for (const float perspective : {1.0f, 0.0f}) {
    EXPECT_EQ(screen_share(sphere_screen_bounds(vec3(0.0f, 0.0f, 2.0f), 1.9f, kNdcToView, perspective)), 0.0f);
    EXPECT_EQ(screen_share(sphere_screen_bounds(vec3(9.0f, 0.0f, -2.0f), 1.0f, kNdcToView, perspective)), 0.0f);
    EXPECT_EQ(screen_share(sphere_screen_bounds(vec3(0.0f, -9.0f, -2.0f), 1.0f, kNdcToView, perspective)), 0.0f);
  }
}

struct Plane {
  glm::dvec3 normal;  // outward where the corners are counter-clockwise
  double distance;
};

// Null at the poles, where two corners are one.
template <class Vertex>
std::vector<Plane> faces_of(uint vertices, Vertex&& vertex) {
  std::vector<Plane> faces;
  for (uint i = 0; i < vertices; i += 3) {
    const glm::dvec3 a(vertex(i)), b(vertex(i + 1)), c(vertex(i + 2));
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (glm::length(normal) < 1e-6) continue;
    faces.push_back({glm::normalize(normal), glm::dot(glm::normalize(normal), a)});
  }
  return faces;
}

TEST(LightVolumes, SphereBodyHoldsTheSphere) {
  EXPECT_EQ(kSphereVertices, 6u * kVolumeSectors * kSphereStacks);
  const auto faces = faces_of(kSphereVertices, sphere_volume_point);
  EXPECT_EQ(faces.size(), 2u * kVolumeSectors * (kSphereStacks - 1u));
  for (const Plane& face : faces) EXPECT_GE(face.distance, 1.0);
  for (uint i = 0; i < kSphereVertices; ++i) EXPECT_LT(length(sphere_volume_point(i)), 1.08f);
}

TEST(LightVolumes, ConeBodyHoldsTheSector) {
  EXPECT_EQ(kConeVertices, 6u * kVolumeSectors * kConeStacks);
  Random random(3);
  for (const float degrees_outer : {2.0f, 20.0f, 44.9f}) {
    const auto cos_outer = static_cast<float>(std::cos(radians(degrees_outer)));
    const auto faces = faces_of(kConeVertices, [&](uint i) { return cone_volume_point(i, cos_outer); });
    EXPECT_EQ(faces.size(), 2u * kVolumeSectors);
    for (int i = 0; i < 2000; ++i) {
      const float height = random.uniform(cos_outer, 1.0f), turn = random.uniform(0.0f, kTwoPi);
      const float side = std::sqrt(1.0f - height * height);
      const glm::dvec3 point =
          double{random.uniform()} * glm::dvec3(side * std::cos(turn), side * std::sin(turn), height);
      for (const Plane& face : faces) ASSERT_LT(glm::dot(face.normal, point), face.distance);
    }
  }
}

// Each edge is met once in each direction, with the same bits: marks in the stencil would leak through a gap.
TEST(LightVolumes, BodiesAreClosed) {
  using Corner = std::array<float, 3>;
  for (const bool sphere : {true, false}) {
    std::vector<std::pair<Corner, Corner>> edges;
    const auto corner = [&](uint i) {
      const vec3 p = sphere ? sphere_volume_point(i) : cone_volume_point(i, 0.8f);
      return Corner{p.x, p.y, p.z};
    };
    for (uint i = 0; i < (sphere ? kSphereVertices : kConeVertices); i += 3)
      for (uint e = 0; e < 3; ++e)
        if (corner(i + e) != corner(i + (e + 1) % 3)) edges.emplace_back(corner(i + e), corner(i + (e + 1) % 3));
    for (const auto& [from, to] : edges)
      EXPECT_EQ(std::count(edges.begin(), edges.end(), std::pair(from, to)),
                std::count(edges.begin(), edges.end(), std::pair(to, from)));
  }
}

}  // namespace
}  // namespace velarium::shading
