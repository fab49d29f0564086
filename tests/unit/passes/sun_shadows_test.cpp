// Where the maps of the sun lie: splits and spheres by the numbers of the notes, texels that stay where they are.

#include "passes/sun_shadows/cascade_fit.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <random>

namespace velarium::sun_shadows {
namespace {

class Random {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 8) / 16777216.0;
  }
  glm::dvec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  glm::dvec3 direction() { return glm::normalize(point(1.0)); }

 private:
  std::mt19937 engine_{1};
};

// 60 degrees upright, 16:9.
View wide_view() {
  const double up = std::tan(glm::radians(30.0));
  return {.half = {up * 16.0 / 9.0, up}};
}

glm::dvec3 right_of(const View& view) {
  const glm::dvec3 side = std::abs(view.forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(view.forward, side));
}

// A corner of the view at a depth.
glm::dvec3 corner_at(const View& view, double depth, double x, double y) {
  const glm::dvec3 right = right_of(view), up = glm::cross(right, view.forward);
  const glm::dvec2 half = view.half * (view.perspective ? depth : 1.0);
  return view.eye + view.forward * depth + right * (x * half.x) + up * (y * half.y);
}

MapLimits limits_of(int size, double margin = 0.0) {
  return {.scene = {glm::dvec3(-1e4), glm::dvec3(1e4)}, .margin = margin, .blocker_distance = 100.0, .size = size};
}

TEST(Splits, FollowThePracticalScheme) {
  const auto expect = [](const DepthRange& range, double lambda, const std::vector<double>& depths) {
    const auto split = split_depths(range, 5, lambda);
    ASSERT_EQ(split.size(), depths.size());
    for (std::size_t i = 0; i < depths.size(); ++i) EXPECT_NEAR(split[i], depths[i], 6e-4 * depths[i]) << i;
  };
  expect({0.1, 400.0}, 1.0, {0.1, 0.525, 2.759, 14.50, 76.15, 400.0});
  expect({0.1, 400.0}, 0.75, {0.1, 20.41, 42.09, 70.88, 137.1, 400.0});
  expect({1.0, 400.0}, 0.75, {1.0, 22.69, 48.39, 87.41, 170.6, 400.0});
}

TEST(SliceSpheres, AreTheSmallestOnes) {
  const Sphere near = slice_sphere(wide_view(), {5.0, 15.0});
  EXPECT_NEAR(near.center.z, -15.0, 1e-9);
  EXPECT_NEAR(near.radius, 17.665, 1e-3);
  EXPECT_NEAR(2.0 * near.radius / 1024, 0.0345, 5e-5);
  EXPECT_NEAR(slice_sphere(wide_view(), {45.0, 135.0}).radius, 158.98, 0.01);
  const Sphere thin = slice_sphere(wide_view(), {1.0, 1.05});
  EXPECT_NEAR(-thin.center.z, 1.05, 1e-9);
  View narrow = wide_view();
  narrow.half = {0.1, 0.1};
  const Sphere long_slice = slice_sphere(narrow, {1.0, 10.0});
  EXPECT_NEAR(-long_slice.center.z, 0.5 * 11.0 * 1.02, 1e-9);
}

TEST(SliceSpheres, HoldAllCorners) {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const View view{.eye = random.point(50.0),
                    .forward = random.direction(),
                    .half = {random.uniform(0.05, 2.0), random.uniform(0.05, 2.0)},
                    .perspective = i % 2 == 0};
    const double near = random.uniform(0.0, 10.0);
    const DepthRange slice{near, near + random.uniform(0.1, 100.0)};
    const Sphere sphere = slice_sphere(view, slice);
    double farthest = 0.0;
    for (const double depth : {slice.near, slice.far})
      for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
          farthest = std::max(farthest, glm::length(corner_at(view, depth, x, y) - sphere.center));
    EXPECT_NEAR(farthest, sphere.radius, 1e-9 * (1.0 + sphere.radius));
  }
}

TEST(VisibleDepths, HoldTheSceneAndStayWhileTheViewerMovesALittle) {
  View view = wide_view();
  const Sphere scene{{0.0, 0.0, -20.0}, 5.0};
  const DepthRange range = visible_depths(view, scene, 0.0);
  EXPECT_LE(range.near, 15.0);
  EXPECT_GT(range.near, 12.0);
  EXPECT_GE(range.far, 25.0);
  EXPECT_LT(range.far, 30.0);
  view.eye.z -= 0.05;
  EXPECT_EQ(visible_depths(view, scene, 0.0).far, range.far);
  view.eye.z = -20.0;
  EXPECT_EQ(visible_depths(view, scene, 0.0).near, 0.0);
  EXPECT_GE(visible_depths(view, scene, 3.0).far, 3.0);
  EXPECT_LT(visible_depths(view, scene, 3.0).far, 3.6);
}

TEST(LightAxes, AreRightHandedPicturesFromTheSun) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 to_sun = i == 0 ? glm::dvec3(0, 1, 0) : random.direction();
    const glm::dmat3 axes = passes::light_axes(to_sun);
    EXPECT_LT(glm::length(axes * to_sun - glm::dvec3(0, 0, 1)), 1e-12);
    // Down the picture is against up: seen from the sun, x right and y down are left-handed with the way to it.
    EXPECT_NEAR(glm::determinant(axes), -1.0, 1e-12);
  }
}

// However the viewer moves, a point of the world lies at the same place within its texel, and texels keep their size.
TEST(Snapping, KeepsTexelsWhereTheyAre) {
  Random random;
  const glm::dmat3 axes = passes::light_axes(glm::normalize(glm::dvec3(0.3, 1.0, 0.2)));
  const glm::dvec3 point(12.3, 4.5, -67.8);
  double texel = 0.0, worst = 0.0;
  glm::dvec2 phase(0.0);
  for (int i = 0; i < 1000; ++i) {
    View view = wide_view();
    view.eye = random.point(100.0);
    view.forward = random.direction();
    const Map map = fit_map(axes, slice_sphere(view, {5.0, 15.0}), limits_of(1024));
    const glm::dvec2 place = (glm::dvec2(axes * point) - map.corner) / map.texel();
    const glm::dvec2 now = place - glm::floor(place);
    if (i == 0) {
      phase = now;
      texel = map.texel();
    }
    const glm::dvec2 moved = glm::abs(now - phase);
    worst = std::max({worst, std::min(moved.x, 1.0 - moved.x), std::min(moved.y, 1.0 - moved.y)});
    EXPECT_EQ(map.texel(), texel);
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(Maps, HoldTheirSphereAndFilters) {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const Sphere sphere{random.point(50.0), random.uniform(0.1, 20.0)};
    const double margin = random.uniform(0.0, sphere.radius);
    const glm::dmat3 axes = passes::light_axes(random.direction());
    const Map map = fit_map(axes, sphere, limits_of(512, margin));
    EXPECT_TRUE(covers(map, sphere, margin));
    const Sphere beside{sphere.center + glm::transpose(axes)[0] * 3.0 * map.side, sphere.radius};
    EXPECT_FALSE(covers(map, beside, margin));
    const auto cascade = gpu_cascade(map, sphere.center, {.radius = margin, .distance = 1.0});
    // The sphere's outermost points are inside what a filter leaves, seen from an eye at its centre.
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 at = random.direction() * sphere.radius;
      const glm::vec3 place = shading::shadow_coord(cascade, glm::vec3(axes * at));
      EXPECT_GT(shading::cascade_weight(cascade, place), 0.0f);
      EXPECT_GE(place.z, 0.0f);
      EXPECT_LE(place.z, 1.0f);
    }
  }
}

TEST(Maps, AreTheSameToRasterAndToShaders) {
  Random random;
  const glm::dmat3 axes = passes::light_axes(random.direction());
  const glm::dvec3 eye = random.point(1000.0);
  const Map map = fit_map(axes, {eye + random.point(5.0), 10.0}, limits_of(2048));
  const glm::mat4 clip = clip_from_world(map, eye);
  const auto cascade = gpu_cascade(map, eye, {.radius = 0.1, .distance = 20.0});
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 from_eye(random.point(10.0));
    const glm::vec4 clipped = clip * glm::vec4(from_eye, 1.0f);
    const glm::vec3 place = shading::shadow_coord(cascade, glm::vec3(axes * glm::dvec3(from_eye)));
    EXPECT_NEAR(0.5f * clipped.x + 0.5f, place.x, 2e-6f);
    EXPECT_NEAR(0.5f * clipped.y + 0.5f, place.y, 2e-6f);
    EXPECT_NEAR(clipped.z, place.z, 2e-6f);
  }
  EXPECT_NEAR(cascade.soft.x * static_cast<float>(map.side), 0.1f, 1e-6f);
  EXPECT_NEAR(cascade.depth.w * 2048.0f, static_cast<float>(map.side), 1e-4f);
}

// What a filter compares with beside a point is where the point's own plane lies there.
TEST(Maps, KnowThePlaneOfAPoint) {
  Random random;
  const glm::dmat3 axes = passes::light_axes(random.direction());
  const Map map = fit_map(axes, {glm::dvec3(0.0), 10.0}, limits_of(2048));
  const auto cascade = gpu_cascade(map, glm::dvec3(0.0), {.radius = 0.1, .distance = 20.0});
  for (int i = 0; i < 100; ++i) {
    glm::dvec3 normal = random.direction();
    normal.z = std::abs(normal.z) + 0.1;
    normal = glm::normalize(normal);
    const glm::dvec3 along = glm::cross(normal, random.direction());
    const glm::vec3 here = shading::shadow_coord(cascade, glm::vec3(0.0f));
    const glm::vec3 there = shading::shadow_coord(cascade, glm::vec3(along));
    const glm::vec2 slope = shading::cascade_slope(cascade, glm::vec3(normal));
    EXPECT_NEAR(here.z + glm::dot(slope, glm::vec2(there) - glm::vec2(here)), there.z, 1e-5f);
  }
}

// Cascade 2 every second picture, 3 at N mod 4 = 1, 4 at N mod 8 = 3: the schedule of the notes.
TEST(Staggering, DrawsOneFarMapAPictureAtMost) {
  for (std::uint64_t picture = 0; picture < 64; ++picture) {
    EXPECT_TRUE(is_due(0, picture) && is_due(1, picture));
    EXPECT_EQ(is_due(2, picture), picture % 2 == 0);
    EXPECT_EQ(is_due(3, picture), picture % 4 == 1);
    EXPECT_EQ(is_due(4, picture), picture % 8 == 3);
    EXPECT_EQ(is_due(5, picture), picture % 16 == 7);
    int far = 0;
    for (std::size_t map = 2; map < shading::kMaxCascades; ++map) far += is_due(map, picture) ? 1 : 0;
    EXPECT_LE(far, 1);
  }
}

// Reversed depth, and nothing between the sun and a map is refused.
TEST(Maps, SeeAllCastersTowardsTheSunAndNoneBehind) {
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.2, 1.0, 0.1));
  const glm::dmat3 axes = passes::light_axes(to_sun);
  const Sphere sphere{{3.0, 4.0, 5.0}, 2.0};
  const Map map = fit_map(axes, sphere, limits_of(512));
  const auto planes = caster_planes(map);
  const auto sees = [&](const glm::dvec3& p) {
    for (const auto& plane : planes)
      if (glm::dot(glm::dvec3(plane), p) + plane.w < 0.0) return false;
    return true;
  };
  EXPECT_TRUE(sees(sphere.center));
  EXPECT_TRUE(sees(sphere.center + 500.0 * to_sun));
  EXPECT_FALSE(sees(sphere.center - 5.0 * to_sun));
  EXPECT_FALSE(sees(sphere.center + 5.0 * glm::transpose(axes)[0]));
  EXPECT_FALSE(sees(sphere.center - 5.0 * glm::transpose(axes)[1]));
  const glm::mat4 clip = clip_from_world(map, sphere.center);
  EXPECT_GT((clip * glm::vec4(glm::vec3(to_sun), 1.0f)).z, (clip * glm::vec4(glm::vec3(-to_sun), 1.0f)).z);
  EXPECT_NEAR(map.z_near - map.z_far, 2.0 * sphere.radius + 100.0, 0.5);
}

}  // namespace
}  // namespace velarium::sun_shadows
