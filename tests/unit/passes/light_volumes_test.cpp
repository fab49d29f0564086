// How lights are drawn as bodies, by what they cover of the screen.

#include "passes/light_volumes/plan.hpp"
#include "upload/lights.hpp"

#include <gtest/gtest.h>

#include "shading/host.hpp"

namespace velarium::light_volumes {
namespace {

using shading::vec3;
using shading::vec4;

// 200 x 200 pixels, 90 degrees, along -z.
upload::FrameUniforms square_view() {
  upload::FrameUniforms frame{};
  frame.view_from_world = glm::mat4(1.0f);
  frame.ndc_to_view = {1.0f, -1.0f, 0.0f, 0.0f};
  frame.size = {200.0f, 200.0f, 1.0f / 200.0f, 1.0f / 200.0f};
  frame.perspective = 1.0f;
  return frame;
}

upload::GpuLight sun() {
  return {.direction = {0.0f, -1.0f, 0.0f, shading::kLightDirectional}};
}

upload::GpuLight point(const vec3& position, float range) {
  return {.position_range = vec4(position, range), .direction = {0.0f, 0.0f, -1.0f, shading::kLightPoint}};
}

upload::GpuLight spot(const vec3& position, float range, float cos_outer) {
  auto light = point(position, range);
  light.direction.w = shading::kLightSpot;
  light.cone = {1.0f, 0.0f, cos_outer, 0.0f};
  return light;
}

std::vector<VolumeDraw> plan_of(std::initializer_list<upload::GpuLight> lights) {
  const auto frame = square_view();
  return plan({lights.begin(), lights.size()}, upload::light_bounds(lights, frame.view_from_world), frame);
}

TEST(LightVolumePlan, LightsWithoutAnEndCoverTheScreen) {
  const VolumeDraw suns{.shape = Shape::screen, .kind = 0, .first_light = 0, .light_count = 2};
  const VolumeDraw endless{.shape = Shape::screen, .kind = 1, .first_light = 2};
  EXPECT_EQ(plan_of({sun(), sun(), point({0, 0, -4}, 0.0f)}), (std::vector{suns, endless}));
}

// At 10 m a sphere of 1 m covers (2 / 20)^2 of the screen, which is 400 pixels and a little more.
TEST(LightVolumePlan, CoverageDecides) {
  const VolumeDraw quad{.shape = Shape::quad, .kind = 1}, body{.shape = Shape::sphere, .kind = 1};
  VolumeDraw marked = body;
  marked.marked = true;
  EXPECT_EQ(plan_of({point({0, 0, -10}, 0.9f)}), std::vector{quad});
  EXPECT_EQ(plan_of({point({0, 0, -10}, 1.1f)}), std::vector{body});
  EXPECT_EQ(plan_of({point({0, 0, -10}, 6.0f)}), std::vector{marked});
  EXPECT_EQ(plan_of({point({0, 3, 1}, 4.0f)}), std::vector{marked});
}

TEST(LightVolumePlan, WideSpotsAreSpheres) {
  EXPECT_EQ(plan_of({spot({0, 0, -10}, 4.0f, 0.9f)}).at(0).shape, Shape::cone);
  EXPECT_EQ(plan_of({spot({0, 0, -10}, 4.0f, 0.3f)}).at(0).shape, Shape::sphere);
}

TEST(LightVolumePlan, NeighboursOfOneSortAreOneDraw) {
  const auto far = point({1, 0, -10}, 2.0f), near = point({0, 0, -2}, 1.9f), unseen = point({0, 0, 5}, 1.0f);
  const VolumeDraw two{.shape = Shape::sphere, .kind = 1, .first_light = 0, .light_count = 2};
  const VolumeDraw third{.shape = Shape::sphere, .kind = 1, .first_light = 3};
  EXPECT_EQ(plan_of({far, far, unseen, far}), (std::vector{two, third}));
  EXPECT_EQ(plan_of({near, near}).size(), 2u);  // each needs marks of its own
}

}  // namespace
}  // namespace velarium::light_volumes
