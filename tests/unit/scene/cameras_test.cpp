#include "scene/snapshot.hpp"

#include "expect_near.hpp"

#include <velarium/error.hpp>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace velarium::scene {
namespace {

using test::expect_near;

constexpr float kRounding = 1e-5f;

glm::vec3 project(const glm::mat4& clip_from_view, const glm::vec3& view) {
  const glm::vec4 clip = clip_from_view * glm::vec4(view, 1);
  return glm::vec3(clip) / clip.w;
}

Camera perspective(float fov_degrees, float z_near) {
  Camera camera;
  camera.vertical_fov = glm::radians(fov_degrees);
  camera.z_near = z_near;
  return camera;
}

TEST(Projection, PerspectiveHasReversedDepthAndYDown) {
  const glm::mat4 m = clip_from_view(perspective(90, 0.5f), 2.0f);
  expect_near(project(m, {0, 0, -0.5f}), {0, 0, 1});
  expect_near(project(m, {0, 0, -5}), {0, 0, 0.1f});
  expect_near(project(m, {0, 3, -3}), {0, -1, 0.5f / 3});  // the upper edge of the picture
  expect_near(project(m, {6, 0, -3}), {1, 0, 0.5f / 3});   // the right edge, at twice the height
  EXPECT_EQ(project(m, {0, 0, -1e30f}).z, 0.5e-30f);       // no far plane
}

TEST(Projection, ANearPlaneOfZeroIsReplaced) {
  EXPECT_GT(project(clip_from_view(perspective(90, 0), 1), {0, 0, -1}).z, 0.0f);
}

TEST(Projection, APictureOfAnotherShapeShowsAllThatThePerspectiveCameraFrames) {
  Camera camera = perspective(90, 0.1f);
  camera.aspect = 2.0f;  // frames |x| <= 2, |y| <= 1 at distance 1
  const glm::vec3 corner(2, 1, -1);
  expect_near(project(clip_from_view(camera, 2.0f), corner), {1, -1, 0.1f});
  expect_near(project(clip_from_view(camera, 4.0f), corner), {0.5f, -1, 0.1f});
  expect_near(project(clip_from_view(camera, 1.0f), corner), {1, -0.5f, 0.1f});
}

TEST(Projection, OrthographicHasReversedDepthBetweenItsPlanes) {
  Camera camera;
  camera.kind = Camera::Kind::orthographic;
  camera.half_size = {4, 2};
  camera.z_near = 1;
  camera.z_far = 11;
  const glm::mat4 m = clip_from_view(camera, 2.0f);
  expect_near(project(m, {4, 2, -1}), {1, -1, 1});
  expect_near(project(m, {-4, -2, -11}), {-1, 1, 0});
  expect_near(project(m, {0, 0, -6}), {0, 0, 0.5f});
  expect_near(project(clip_from_view(camera, 1.0f), {4, 2, -1}), {1, -0.5f, 1});
  expect_near(project(clip_from_view(camera, 8.0f), {4, 2, -1}), {0.25f, -1, 1});
}

TEST(LookAt, StandsAtTheEyeAndLooksAtTheTarget) {
  const CameraInstance c = look_at_camera({1, 2, 3}, {1, 2, -7}, {0, 5, 0}, 0.5f);
  expect_near(glm::vec3(c.world_from_view[3]), {1, 2, 3});
  expect_near(-glm::vec3(c.world_from_view[2]), {0, 0, -1});
  expect_near(glm::vec3(c.world_from_view[1]), {0, 1, 0});
  expect_near(glm::vec3(c.world_from_view[0]), {1, 0, 0});
  EXPECT_EQ(c.camera.vertical_fov, 0.5f);
  const CameraInstance up = look_at_camera({0, 0, 0}, {0, 8, 0}, {0, 0, 1}, 0.5f);
  expect_near(-glm::vec3(up.world_from_view[2]), {0, 1, 0});
  EXPECT_NEAR(glm::determinant(up.world_from_view), 1.0f, kRounding);
}

TEST(LookAt, RefusesViewsThatAreNone) {
  EXPECT_THROW((void)look_at_camera({1, 1, 1}, {1, 1, 1}, {0, 1, 0}, 1), Error);
  EXPECT_THROW((void)look_at_camera({0, 2, 0}, {0, 0, 0}, {0, 1, 0}, 1), Error);
  EXPECT_THROW((void)look_at_camera({0, 2, 0}, {0, 0, 0}, {0, -3, 0}, 1), Error);
  EXPECT_THROW((void)look_at_camera({0, 0, 2}, {0, 0, 0}, {0, 0, 0}, 1), Error);
}

struct Framed {
  glm::vec2 min{1e9f}, max{-1e9f};
  float nearest = 1e9f;
};

Framed framed(const CameraInstance& c, const WorldAabb& box, float aspect) {
  Framed out;
  const glm::dmat4 view_from_world = glm::inverse(c.world_from_view);
  const glm::mat4 clip = clip_from_view(c.camera, aspect);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                            (i & 4) ? box.max.z : box.min.z);
    const glm::vec3 view(view_from_world * glm::dvec4(corner, 1));
    const glm::vec2 p(project(clip, view));
    out.min = glm::min(out.min, p);
    out.max = glm::max(out.max, p);
    out.nearest = std::min(out.nearest, -view.z);
  }
  return out;
}

TEST(FittedCamera, SeesTheWholeBoxCentredAndJustInside) {
  const std::array<WorldAabb, 6> boxes{{{{-1, -1, -1}, {1, 1, 1}},
                                        {{100, 0, -50}, {101, 30, -49}},
                                        {{-500, 0, -400}, {500, 1, 400}},
                                        {{0, 0, 0}, {0.001, 0.002, 0.003}},
                                        {{0, 0, 0}, {1e-6, 2e-6, 3e-6}},
                                        {{-1, 0, -1}, {1, 0, 1}}}};
  for (const WorldAabb& box : boxes) {
    for (const float aspect : {0.25f, 1.0f, 16.0f / 9.0f, 4.0f}) {
      const CameraInstance c = fitted_camera(box, aspect);
      const Framed f = framed(c, box, aspect);
      const float widest = std::max(f.max.x, f.max.y);
      EXPECT_LT(widest, 0.97f);
      EXPECT_GT(widest, 0.90f);
      EXPECT_NEAR(f.min.x, -f.max.x, 1e-2f);
      EXPECT_NEAR(f.min.y, -f.max.y, 1e-2f);
      EXPECT_GT(f.nearest, c.camera.z_near);
      EXPECT_GT(c.camera.z_near, 0.0f);
      EXPECT_GT(c.world_from_view[2].y, 0.1f) << "looks down";
    }
  }
}

TEST(FittedCamera, ServesScenesOfNoOrInfiniteExtent) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::array<WorldAabb, 5> boxes{{{},
                                        {glm::dvec3(3), glm::dvec3(3)},
                                        {glm::dvec3(1e8), glm::dvec3(1e8)},
                                        {glm::dvec3(-3e38), glm::dvec3(3e38)},
                                        {glm::dvec3(-infinity), glm::dvec3(infinity)}}};
  for (const WorldAabb& box : boxes) {
    const CameraInstance c = fitted_camera(box, 1.5f);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(c.world_from_view[column][row]));
    }
    EXPECT_GT(c.camera.z_near, 0.0f);
  }
}

TEST(ChooseCamera, ByNameThenIndexElseFirstElseFitted) {
  SceneSnapshot snapshot;
  snapshot.bounds = {glm::vec3(-1), glm::vec3(1)};
  EXPECT_EQ(choose_camera(snapshot, "", 1).camera.name, "auto");
  snapshot.cameras.resize(2);
  snapshot.cameras[0].camera.name = "front";
  snapshot.cameras[1].camera.name = "back";
  EXPECT_EQ(choose_camera(snapshot, "", 1).camera.name, "front");
  EXPECT_EQ(choose_camera(snapshot, "back", 1).camera.name, "back");
  EXPECT_EQ(choose_camera(snapshot, "1", 1).camera.name, "back");
  EXPECT_EQ(choose_camera(snapshot, "auto", 1).camera.name, "auto");
  try {
    (void)choose_camera(snapshot, "side", 1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::usage);
    EXPECT_NE(std::string(error.what()).find("\"front\""), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("\"back\""), std::string::npos);
  }
}

}  // namespace
}  // namespace velarium::scene
