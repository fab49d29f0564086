// Requests and scenes at the edge of what makes sense: a picture, or an error that says what to change.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

namespace velarium::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Scene spheres() {
  return Scene::load("builtin:spheres");
}

RenderRequest small() {
  RenderRequest request = linear_request(32, 32);
  request.environment = "white";
  return request;
}

// Why a request for the spheres is refused.
std::optional<ErrorCode> refusal_of(const std::function<void(RenderRequest&)>& change) {
  RenderRequest request = small();
  change(request);
  try {
    (void)picture_of(spheres(), request);
  } catch (const Error& error) { return error.code(); }
  return std::nullopt;
}

TEST(Requests, SizesThatTheDeviceDoesNotTakeAreRefused) {
  for (const auto& [width, height] : {std::pair{0u, 32u}, {32u, 0u}, {1u << 20, 1u}, {1u, 0xffffffffu}}) {
    const auto code = refusal_of([width = width, height = height](RenderRequest& request) {
      request.width = width;
      request.height = height;
    });
    EXPECT_EQ(code, ErrorCode::usage) << width << "x" << height;
  }
}

TEST(Requests, CamerasThatAreNoneAreRefused) {
  const std::vector<LookAt> none{{.eye = {kNaN, 0, 1}},
                                 {.target = {0, kNaN, 0}},
                                 {.up = {0, kNaN, 0}},
                                 {.eye = {0, 0, kInfinity}},
                                 {.target = {kInfinity, 0, 0}},
                                 {.eye = {1, 2, 3}, .target = {1, 2, 3}},
                                 {.up = {0, 0, 0}},
                                 {.up = {0, 0, 1}},
                                 {.vertical_fov_deg = kNaN},
                                 {.vertical_fov_deg = 0.0f},
                                 {.vertical_fov_deg = -30.0f},
                                 {.vertical_fov_deg = 180.0f},
                                 {.vertical_fov_deg = kInfinity}};
  for (std::size_t i = 0; i < none.size(); ++i)
    EXPECT_EQ(refusal_of([&](RenderRequest& request) { request.look_at = none[i]; }), ErrorCode::usage) << "row " << i;
}

TEST(Requests, NamesThatDoNotExistAreRefused) {
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.camera = "nobody"; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.animation = "nothing"; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.dumps = {"gbuffer.nothing"}; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.environment = "nowhere.hdr"; }), ErrorCode::input_missing);
}

TEST(Requests, SettingsOutOfTheirRangesAreRefused) {
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.settings.frame.spp = 0; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.settings.output.bits = 12; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.settings.environment.intensity = -1.0f; }),
            ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.settings.display.exposure = kNaN; }), ErrorCode::usage);
}

TEST(Requests, SunsOutOfTheirRangesAreRefused) {
  for (const Sun& sun : {Sun{.elevation_deg = 90.5f}, Sun{.azimuth_deg = kNaN}, Sun{.illuminance_lux = -1.0f},
                         Sun{.illuminance_lux = kInfinity}, Sun{.angular_radius_deg = 90.0f}})
    EXPECT_EQ(refusal_of([&](RenderRequest& request) { request.sun = sun; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.sun = Sun{.elevation_deg = -90.0f}; }), std::nullopt);
}

TEST(Requests, BackgroundsThatAreNoColorAreRefused) {
  for (const float channel : {-0.1f, 1.1f, kNaN})
    EXPECT_EQ(refusal_of([&](RenderRequest& request) { request.background_color[1] = channel; }), ErrorCode::usage);
}

TEST(Requests, TimesAreRefusedOnlyWhereTheyAreNone) {
  for (const float time : {kNaN, kInfinity, -kInfinity})
    EXPECT_EQ(refusal_of([&](RenderRequest& request) { request.time_s = time; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.time_s = -1e30f; }), std::nullopt);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.time_s = 1e30f; }), std::nullopt);
}

TEST(Requests, AnEngineSurvivesARefusal) {
  const Picture before = picture_of(spheres(), small());
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.dumps = {"no.image"}; }), ErrorCode::usage);
  EXPECT_EQ(refusal_of([](RenderRequest& request) { request.width = 0; }), ErrorCode::usage);
  EXPECT_EQ(largest_error(before.linear, picture_of(spheres(), small()).linear), 0.0);
}

TEST(Views, AnEmptySceneShowsTheBackground) {
  const Scene empty = GltfWriter().load();
  const Picture white = picture_of(empty, small());
  EXPECT_TRUE(std::all_of(white.linear.begin(), white.linear.end(), [](float value) { return value == 1.0f; }));
  RenderRequest request = small();
  request.background = Background::transparent;
  const Picture clear = picture_of(empty, request);
  EXPECT_TRUE(std::all_of(clear.linear.begin(), clear.linear.end(), [](float value) { return value == 0.0f; }));
}

TEST(Views, FromInsideGeometry) {
  RenderRequest request = small();
  // The middle of a sphere of the front row: its back faces are not drawn.
  request.look_at = LookAt{.eye = {0.0f, 0.45f, 2.3f}, .target = {0.0f, 0.45f, 0.0f}};
  EXPECT_TRUE(is_finite(picture_of(spheres(), request)));
  // In the plane of the ground.
  request.look_at = LookAt{.eye = {0.0f, 0.0f, 5.0f}, .target = {0.0f, 0.0f, 0.0f}};
  EXPECT_TRUE(is_finite(picture_of(spheres(), request)));
  // With everything behind.
  request.look_at = LookAt{.eye = {0.0f, 1.0f, 9.0f}, .target = {0.0f, 1.0f, 20.0f}};
  const Picture away = picture_of(spheres(), request);
  EXPECT_TRUE(std::all_of(away.linear.begin(), away.linear.end(), [](float value) { return value == 1.0f; }));
}

TEST(Views, FromVeryNearAndVeryFar) {
  for (const float distance : {1e-4f, 1e6f, 1e12f}) {
    RenderRequest request = small();
    request.look_at = LookAt{.eye = {0.0f, 0.0f, distance}, .vertical_fov_deg = 1.0f};
    EXPECT_TRUE(is_finite(picture_of(spheres(), request))) << distance << " m";
  }
}

// A floor under lights that are hard to divide by.
TEST(Lights, WithoutIntensityOnSurfacesAndAtTheEye) {
  const glm::vec3 eye(0.0f, 1.0f, 2.0f);
  const auto lit_by = [&](const std::vector<TestLight>& lights) {
    GltfWriter scene;
    const int floor = scene.add_material({.metallic = 0.5f, .perceptual_roughness = 0.0f, .specular = 1.0f});
    const int pane = scene.add_material({.base_color = {1, 1, 1, 0.5f}, .alpha_mode = "BLEND"});
    scene.add_quad(floor, {0, 0, 0}, {0, 1, 0}, {8, 8});
    scene.add_quad(pane, {0, 1, 0}, {0, 0, 1}, {1, 1});
    for (const TestLight& light : lights) scene.add_light(light);
    RenderRequest request = linear_request(32, 32);
    request.look_at = LookAt{.eye = {eye.x, eye.y, eye.z}};
    return picture_of(scene.load(), request);
  };
  const auto is_black = [](const Picture& picture) {
    for (std::size_t i = 0; i < picture.linear.size(); ++i)
      if (i % 4 != 3 && picture.linear[i] != 0.0f) return false;
    return true;
  };
  EXPECT_TRUE(is_black(lit_by({{.intensity = 0.0f}, {.type = "directional", .intensity = 0.0f}})));
  EXPECT_TRUE(is_black(lit_by({{.color = {0, 0, 0}, .position = {0, 1, 1}}})));
  for (const glm::vec3& position : {eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, -1.0f, 0.0f)}) {
    for (const char* type : {"point", "spot"}) {
      const TestLight light{.type = type, .intensity = 1e6f, .position = position, .direction = {0, -1, 0}};
      EXPECT_TRUE(is_finite(lit_by({light}))) << type << " at " << position.x << ", " << position.y;
    }
  }
  EXPECT_FALSE(is_black(lit_by({{.intensity = 1.0f, .position = eye}})));
}

std::size_t different_pixels(const Picture& a, const Picture& b) {
  std::size_t count = 0;
  for (std::uint32_t y = 0; y < a.height; ++y)
    for (std::uint32_t x = 0; x < a.width; ++x) count += linear_at(a, x, y) != linear_at(b, x, y) ? 1u : 0u;
  return count;
}

// 102400 m away: floats there are multiples of 1/128 m, and so are all places of the scene, so that the two scenes are
// the same and only what the renderer makes of them could differ.
TEST(Places, AHundredKilometresFromTheOriginNothingTrembles) {
  const glm::vec3 far(102400.0f, 0.0f, -102400.0f);
  const auto view_of = [](const glm::vec3& origin, bool sun_shadows) {
    GltfWriter scene(origin);
    const TestMaterial matt{.base_color = {0.7f, 0.5f, 0.3f, 1}}, metal{.metallic = 1.0f, .perceptual_roughness = 0.3f};
    scene.add_quad(scene.add_material(matt), {0, 0, 0}, {0, 1, 0}, {4, 4});
    scene.add_box(scene.add_material(metal), {0, 0.5f, 0}, {1, 1, 1});
    scene.add_light({.intensity = 2.0f, .range = 6.0f, .position = {1.0f, 1.5f, 1.25f}});
    scene.add_light({.type = "directional", .intensity = 0.5f, .direction = {-1, -2, -1}});
    RenderRequest request = linear_request(96, 72);
    request.environment = "studio";
    request.settings.sun_shadows.enabled = sun_shadows;
    const glm::vec3 eye = origin + glm::vec3(1.5f, 1.25f, 2.5f), target = origin + glm::vec3(0.0f, 0.25f, 0.0f);
    request.look_at = LookAt{.eye = {eye.x, eye.y, eye.z}, .target = {target.x, target.y, target.z}};
    return picture_of(scene.load(), request);
  };
  EXPECT_EQ(largest_error(view_of(glm::vec3(0.0f), false).linear, view_of(far, false).linear), 0.0);
  // The sun's maps lie on a grid of the world, so that their texels lie elsewhere in the scene: where an outline
  // crosses a pixel, that may differ by the share of a texel. It does so half a metre away as well, as much and as
  // seldom.
  const Picture here = view_of(glm::vec3(0.0f), true);
  for (const glm::vec3& place : {glm::vec3(0.5f, 0.0f, 0.0f), far}) {
    const Picture there = view_of(place, true);
    EXPECT_LT(largest_error(here.linear, there.linear), 0.01);
    EXPECT_LE(different_pixels(here, there), 3u);
  }
}

}  // namespace
}  // namespace velarium::test
