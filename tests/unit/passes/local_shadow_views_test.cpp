#include "passes/local_shadows/plan.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::local_shadows {
namespace {

using shading::GpuLight;

constexpr float kFar = 1000.0f;

// At the scene's origin, looking along -z, 90 degrees wide and high.
upload::ViewMatrices camera() {
  glm::mat4 projection(0.0f);
  projection[0][0] = 1.0f;
  projection[1][1] = -1.0f;
  projection[2][3] = -1.0f;
  projection[3][2] = 0.1f;  // reversed, no far plane
  return {.clip_from_view = projection};
}

GpuLight point(const glm::vec3& position, float range = 0.0f) {
  return {.position_range = {position, range},
          .direction = {0, 0, -1, shading::kLightPoint},
          .color = {1, 1, 1, 0},
          .cone = {1, 0, 0.70710678f, 0},
          .flags = shading::kLightCastsShadow};
}

GpuLight spot(const glm::vec3& position, const glm::vec3& direction, float outer, float range = 0.0f) {
  GpuLight light = point(position, range);
  light.direction = {glm::normalize(direction), shading::kLightSpot};
  light.cone.z = std::cos(outer);
  return light;
}

upload::CasterTable casters(std::initializer_list<scene::WorldAabb> boxes) {
  upload::CasterTable table;
  for (const auto& box : boxes) table.casters.push_back({box, {}, upload::CasterKind::opaque});
  return table;
}

// Boxes all around, so that no view is empty.
upload::CasterTable surroundings() {
  return casters({{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}}});
}

std::vector<View> views_of(const GpuLight& light, const upload::CasterTable& table = surroundings()) {
  const auto view = camera();
  return wanted_views(std::span(&light, 1), {view, {100, 100}}, table, true);
}

std::vector<std::uint32_t> faces_of(const std::vector<View>& views) {
  std::vector<std::uint32_t> faces;
  for (const auto& view : views) faces.push_back(view.face);
  return faces;
}

TEST(ShadowCoverage, ABoxInFrontOfTheCameraCoversItsNearSide) {
  const auto view = camera();
  const Solid seen = view_solid(view, glm::dvec3(0.0), 100.0), box = box_solid({-1, -1, -12}, {1, 1, -10});
  const std::array<const Solid*, 2> solids{&seen, &box};
  // 2 of 20 metres at a depth of 10, on both axes.
  EXPECT_NEAR(covered_share(solids, glm::dmat4(view.clip_from_view)), 0.01, 1e-9);
}

TEST(ShadowCoverage, WhatHoldsTheWholeViewCoversAllOfIt) {
  const auto view = camera();
  const Solid seen = view_solid(view, glm::dvec3(0.0), 100.0), box = box_solid(glm::dvec3(-500), glm::dvec3(500));
  const std::array<const Solid*, 2> solids{&seen, &box};
  EXPECT_NEAR(covered_share(solids, glm::dmat4(view.clip_from_view)), 1.0, 1e-6);
}

TEST(ShadowCoverage, NothingBehindOrBesideTheCamera) {
  const auto view = camera();
  const Solid seen = view_solid(view, glm::dvec3(0.0), 100.0);
  for (const glm::dvec3 place : {glm::dvec3(0, 0, 10), glm::dvec3(30, 0, -10), glm::dvec3(0, -30, -10)}) {
    const Solid box = box_solid(place - 1.0, place + 1.0);
    const std::array<const Solid*, 2> solids{&seen, &box};
    EXPECT_EQ(covered_share(solids, glm::dmat4(view.clip_from_view)), 0.0);
  }
}

// A pyramid of half the view's width, from the eye: a quarter of the picture, wherever it ends.
TEST(ShadowCoverage, APyramidFromTheEyeCoversItsOwnShare) {
  const auto view = camera();
  const Solid seen = view_solid(view, glm::dvec3(0.0), 100.0);
  const std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1)};
  for (const double reach : {1.0, 50.0, 1000.0}) {
    const Solid pyramid = pyramid_solid({0, 0, 0}, axes, 0.5, reach);
    const std::array<const Solid*, 2> solids{&seen, &pyramid};
    EXPECT_NEAR(covered_share(solids, glm::dmat4(view.clip_from_view)), 0.25, 1e-6);
  }
}

TEST(ShadowViews, APointInViewHasTheFacesThatReceiversAreIn) {
  // Ten metres ahead with a range of one: all around it is seen.
  EXPECT_EQ(faces_of(views_of(point({0, 0, -10}, 1.0f))), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  // Behind the eye: of what it lights, only what is ahead is seen, through faces that are not turned back.
  const auto behind = faces_of(views_of(point({0, 0, 5})));
  EXPECT_EQ(std::count(behind.begin(), behind.end(), 4u), 0);  // +z
  EXPECT_EQ(std::count(behind.begin(), behind.end(), 5u), 1);  // -z
}

TEST(ShadowViews, LightsThatReachNothingInViewHaveNone) {
  EXPECT_TRUE(views_of(point({0, 0, 5}, 4.0f)).empty());
  EXPECT_TRUE(views_of(point({30, 0, -10}, 5.0f)).empty());
  EXPECT_FALSE(views_of(point({0, 0, 5}, 6.0f)).empty());
}

TEST(ShadowViews, FacesWithoutCastersAreLeftOut) {
  const auto table = casters({{{-1, -6, -11}, {1, -5, -9}}});
  EXPECT_EQ(faces_of(views_of(point({0, 0, -10}), table)), (std::vector<std::uint32_t>{3}));
  EXPECT_TRUE(views_of(point({0, 0, -10}, 4.0f), table).empty());
}

TEST(ShadowViews, OnlyLightsThatCastShadowsHaveViews) {
  GpuLight light = point({0, 0, -10});
  light.flags = 0;
  EXPECT_TRUE(views_of(light).empty());
  light.flags = shading::kLightCastsShadow;
  light.direction.w = shading::kLightDirectional;
  EXPECT_TRUE(views_of(light).empty());
}

// Six metres away along +x, a sheet; a box along -x.
TEST(ShadowViews, TranslucentCastersCountWhereTheyAreWanted) {
  upload::CasterTable table = casters({{{-4, -1, -11}, {-3, 1, -9}}});
  table.casters.push_back({{{6, -1, -11}, {6, 1, -9}}, {}, upload::CasterKind::translucent});
  const GpuLight light = point({0, 0, -10});
  const auto view = camera();
  const auto with = wanted_views(std::span(&light, 1), {view, {100, 100}}, table, true);
  EXPECT_EQ(faces_of(with), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_NEAR(with[0].translucent.nearest, 6.0, 1e-6);
  EXPECT_NEAR(with[0].translucent.low.x, -1.0 / 6.0, 1e-6);
  EXPECT_NEAR(with[0].translucent.high.y, 1.0 / 6.0, 1e-6);
  EXPECT_EQ(with[1].translucent.nearest, 0.0);
  const auto without = wanted_views(std::span(&light, 1), {view, {100, 100}}, table, false);
  EXPECT_EQ(faces_of(without), (std::vector<std::uint32_t>{1}));

  const Plan plan = make_plan(place_views(with, Settings{}), std::span(&light, 1), glm::dvec3(0.0), 4096);
  const auto translucent = [&](const glm::vec3& from_light) {
    const auto& face = plan.views[shading::shadow_face(from_light)];
    const float depth = shading::shadow_view_depth(face, from_light);
    return shading::may_be_translucent(face, depth, shading::shadow_view_uv(face, from_light, depth));
  };
  EXPECT_TRUE(translucent({7, 0, 0}));
  EXPECT_TRUE(translucent({7, 1, -1}));
  EXPECT_FALSE(translucent({5.9f, 0, 0}));  // before it
  EXPECT_FALSE(translucent({7, 3, 0}));     // beside it
  EXPECT_FALSE(translucent({-7, 0, 0}));
  EXPECT_TRUE(plan.draws[0].translucent);
  EXPECT_FALSE(plan.draws[1].translucent);
}

// A sheet that reaches behind the light has no tangents: it may be seen anywhere.
TEST(ShadowViews, SheetsAroundALightMayBeAnywhere) {
  upload::CasterTable table;
  table.casters.push_back({{{-2, -1, -10.5f}, {3, 1, -9.5f}}, {}, upload::CasterKind::translucent});
  const GpuLight light = point({0, 0, -10});
  const auto view = camera();
  for (const auto& from : wanted_views(std::span(&light, 1), {view, {100, 100}}, table, true)) {
    EXPECT_GE(from.translucent.nearest, from.near);
    EXPECT_LE(from.translucent.low.x, -1.0);
    EXPECT_GE(from.translucent.high.x, 1.0);
  }
}

TEST(ShadowViews, NarrowSpotsHaveOneViewAlongTheirAxis) {
  const auto views = views_of(spot({0, 0, -10}, {1, -1, -1}, 0.5f));
  ASSERT_EQ(views.size(), 1u);
  EXPECT_NEAR(glm::length(views[0].axes[2] - glm::normalize(glm::dvec3(1, -1, -1))), 0.0, 1e-6);
  EXPECT_NEAR(views[0].half_tangent, std::tan(0.5), 1e-6);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(glm::length(glm::cross(views[0].axes[i], views[0].axes[(i + 1) % 3]) - views[0].axes[(i + 2) % 3]), 0.0,
                1e-6);
}

// Up to a hemisphere: all faces but the one behind.
TEST(ShadowViews, WideSpotsHaveTheFacesOfTheirCone) {
  const auto faces = faces_of(views_of(spot({0, 0, -10}, {0, -1, 0}, std::numbers::pi_v<float> / 2.0f, 1.0f)));
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 3u), 1);
  EXPECT_EQ(faces_of(views_of(spot({0, 0, -10}, {0, -1, 0}, 1.1f, 1.0f))), (std::vector<std::uint32_t>{0, 1, 3, 4, 5}));
  EXPECT_EQ(views_of(spot({0, 0, -10}, {0, -1, 0}, 1e-4f, 1.0f)).size(), 1u);
}

TEST(ShadowViews, ConesOfNoWidthAndLightsOfNoRangeAreFinite) {
  for (const auto& light : {spot({0, 0, -10}, {0, -1, 0}, 0.0f), point({0, 0, 0}), point({0, 0, -10})})
    for (const auto& view : views_of(light)) {
      EXPECT_TRUE(std::isfinite(view.reach));
      EXPECT_GT(view.near, 0.0);
      EXPECT_LT(view.near, view.reach);
      EXPECT_GT(view.half_tangent, 0.0);
      EXPECT_TRUE(std::isfinite(view.importance));
    }
}

TEST(ShadowViews, SizesFollowTheLogarithmOfCoverage) {
  Settings settings{};
  settings.density = 2.0f;
  settings.largest = 1024;
  View view;
  for (const auto& [pixels, size] : {std::pair{1.0, 32u}, {32.0 * 32.0, 64u}, {100.0 * 100.0, 256u}, {1e7, 1024u}}) {
    view.pixels = pixels;
    EXPECT_EQ(wanted_size(view, settings), size) << pixels;
  }
}

// A place is found by shaders where the rasteriser draws it, at the same depth.
TEST(ShadowPlan, ShadersFindWhatIsDrawn) {
  const std::vector<GpuLight> lights{point({1, 2, -10}, 8.0f), spot({-3, 1, -6}, {1, -1, -2}, 0.7f, 9.0f)};
  const auto view = camera();
  const Settings settings{};
  const auto side = atlas_side(settings);
  const auto placed = place_views(wanted_views(lights, {view, {100, 100}}, surroundings(), true), settings);
  const Plan plan = make_plan(placed, lights, glm::dvec3(0.0), side);
  EXPECT_EQ(plan.views.size(), 7u);
  EXPECT_EQ(plan.first_view, (std::vector<std::uint32_t>{1, 7}));
  ASSERT_EQ(plan.draws.size(), placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const View& from = placed[i].view;
    const glm::vec3 q(2.0 * from.axes[2] + 0.6 * from.axes[0] - 0.3 * from.axes[1]);
    if (from.light == 0) { EXPECT_EQ(shading::shadow_face(q), from.face); }
    const auto& table = plan.views[plan.first_view[from.light] - 1 + from.face];
    const float depth = shading::shadow_view_depth(table, q);
    const glm::vec2 uv = shading::shadow_view_uv(table, q, depth);
    const glm::vec4 clip = plan.draws[i].clip_from_world * glm::vec4(glm::vec3(from.position) + q, 1.0f);
    const Tile& tile = plan.draws[i].tile;
    const glm::vec2 texel =
        glm::vec2(tile.x, tile.y) + static_cast<float>(tile.size) * (0.5f + 0.5f * glm::vec2(clip) / clip.w);
    EXPECT_NEAR(uv.x * static_cast<float>(side), texel.x, 0.02f);
    EXPECT_NEAR(uv.y * static_cast<float>(side), texel.y, 0.02f);
    EXPECT_NEAR(depth, 2.0f, 1e-5f);
    EXPECT_NEAR(table.forward.w / depth, clip.z / clip.w, 1e-6f);
  }
}

// Every direction of a face, and what filters read around it, lies in the face's own tile.
TEST(ShadowPlan, FiltersStayInTheirTile) {
  std::vector<GpuLight> lights{point({0, 0, -10}, 4.0f), point({2, 0, -10}, 4.0f)};
  lights[1].color.w = 0.2f;
  const auto view = camera();
  const Settings settings{};
  const double side = atlas_side(settings);
  const auto placed = place_views(wanted_views(lights, {view, {100, 100}}, surroundings(), true), settings);
  const Plan plan = make_plan(placed, lights, glm::dvec3(0.0), atlas_side(settings));
  for (const auto& [from, tile, redraw] : placed) {
    ASSERT_TRUE(tile);
    const auto& table = plan.views[plan.first_view[from.light] - 1 + from.face];
    const glm::vec3 rim(from.axes[2] + (1.0 + static_cast<double>(table.tile.y)) * from.axes[0]);
    const double x = static_cast<double>(shading::shadow_view_uv(table, rim, 1.0f).x) * side;
    const double from_middle = std::abs(x - (tile->x + 0.5 * tile->size));
    const double y = std::abs(static_cast<double>(shading::shadow_view_uv(table, rim, 1.0f).y) * side -
                              (tile->y + 0.5 * tile->size));
    EXPECT_NEAR(std::max(from_middle, y), 0.5 * tile->size - static_cast<double>(shading::kShadowBorder), 0.02);
  }
  EXPECT_EQ(plan.views[0].tile.y, 0.0f);
  EXPECT_GT(plan.views[6].tile.y, 0.0f);
}

TEST(ShadowPlan, ALightWithoutRoomShinesThrough) {
  std::vector<GpuLight> lights(40, point({0, 0, -10}, 1.0f));
  lights[7].color = {100, 100, 100, 0};
  const auto view = camera();
  Settings settings{};
  settings.atlas = 256;  // 64 of the smallest tiles, ten lights' worth
  const auto placed = place_views(wanted_views(lights, {view, {100, 100}}, surroundings(), true), settings);
  const Plan plan = make_plan(placed, lights, glm::dvec3(0.0), atlas_side(settings));
  EXPECT_EQ(std::count(plan.first_view.begin(), plan.first_view.end(), 0u), 30);
  EXPECT_NE(plan.first_view[7], 0u);
  EXPECT_EQ(plan.views.size(), 60u);
}

// A light of 0.1 m, two metres above a floor.
View over_floor(const upload::CasterTable& table) {
  GpuLight light = point({0, 0, -10});
  light.color.w = 0.1f;
  return views_of(light, table).front();
}

// The kernel is a sixteenth or a multiple of it, half as wide again as R / distance at least.
TEST(ShadowViews, FiltersAreAsWideAsTheNearestCastersPenumbra) {
  EXPECT_EQ(over_floor(casters({{{-5, -3, -15}, {5, -2, -5}}})).kernel, 2.0f / 16.0f);     // 0.15 / 2
  EXPECT_EQ(over_floor(casters({{{-5, -3, -15}, {5, -0.5f, -5}}})).kernel, 5.0f / 16.0f);  // 0.15 / 0.5
  EXPECT_EQ(over_floor(surroundings()).kernel, 1.0f);                                      // within it
}

TEST(ShadowViews, PointsNeedNoRoomForFilters) {
  EXPECT_EQ(views_of(point({0, 0, -10})).front().kernel, 0.0f);
}

}  // namespace
}  // namespace velarium::local_shadows
