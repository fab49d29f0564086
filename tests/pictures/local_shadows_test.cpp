// Shadows of point and spot lights against the path tracer, against pictures without shadows, and against themselves.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <velarium/compare.hpp>
#include <velarium/reference.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::test {
namespace {

constexpr std::uint32_t kWidth = 128, kHeight = 96;

RenderRequest request_from(const std::array<float, 3>& eye, const std::array<float, 3>& target) {
  RenderRequest request = linear_request(kWidth, kHeight);
  request.look_at = LookAt{.eye = eye, .target = target};
  return request;
}

RenderRequest request() {
  return request_from({3, 3, 4}, {0, 0.5f, 0});
}

RenderRequest without_shadows(RenderRequest request) {
  request.settings.local_shadows.enabled = false;
  return request;
}

// A floor, three boxes on it, and one in the air.
GltfWriter plane_with_boxes() {
  GltfWriter scene;
  const int grey = scene.add_material({.base_color = {0.7f, 0.7f, 0.7f, 1}});
  scene.add_quad(grey, {0, 0, 0}, {0, 1, 0}, {12, 12});
  scene.add_box(grey, {0, 0.5f, 0}, {1, 1, 1});
  scene.add_box(grey, {1.5f, 0.25f, 0.8f}, {0.5f, 0.5f, 0.8f});
  scene.add_box(grey, {-1.6f, 0.8f, -0.4f}, {0.3f, 1.6f, 0.3f});
  scene.add_box(grey, {0.4f, 1.3f, 1.2f}, {1.0f, 0.1f, 0.4f});
  return scene;
}

// Six walls that look inwards, about the origin.
GltfWriter room() {
  GltfWriter scene;
  const int grey = scene.add_material({.base_color = {0.7f, 0.7f, 0.7f, 1}});
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      glm::vec3 normal(0.0f);
      normal[axis] = sign;
      scene.add_quad(grey, -2.0f * normal, normal, {4, 4});
    }
  return scene;
}

TestLight test_light(const std::string& type, float radius = 0.0f) {
  TestLight light{.type = type,
                  .intensity = 40.0f,
                  .inner_cone = 0.4f,
                  .outer_cone = 0.6f,
                  .position = {1.2f, 2.6f, 2.0f},
                  .direction = {-1.2f, -2.4f, -2.0f}};
  if (radius > 0.0f) light.extras = {{"radius", radius}};
  return light;
}

double flip_to_truth(const Scene& scene, const RenderRequest& view) {
  ReferenceRequest traced{.view = view};
  traced.view.settings.reference.spp = 64;
  traced.view.settings.reference.transport = Transport::direct;
  RenderRequest drawn = view;
  drawn.settings.frame.spp = 16;
  drawn.settings.local_shadows.density = 4.0f;  // of a picture so small, edges are a large part
  return compare(picture_of(scene, drawn), render_reference(scene, traced).picture).flip;
}

double flip_of(const TestLight& light) {
  GltfWriter scene = plane_with_boxes();
  scene.add_light(light);
  return flip_to_truth(scene.load(), request());
}

TEST(LocalShadows, PointsCastThePathTracersShadows) {
  EXPECT_LT(flip_of(test_light("point")), 0.02);
}

TEST(LocalShadows, SpotsCastThePathTracersShadows) {
  EXPECT_LT(flip_of(test_light("spot")), 0.02);
  TestLight wide = test_light("spot");
  wide.outer_cone = 1.5f;  // six views
  EXPECT_LT(flip_of(wide), 0.02);
}

TEST(LocalShadows, PenumbraeAreThePathTracers) {
  EXPECT_LT(flip_of(test_light("point", 0.1f)), 0.03);
  EXPECT_LT(flip_of(test_light("spot", 0.1f)), 0.03);
}

// A plate under a light whose penumbra is wider than the plate is high above the floor, as that of a torch's cup.
TEST(LocalShadows, WhatStandsRightBesideABulbHasAWidePenumbra) {
  GltfWriter scene;
  const int grey = scene.add_material({.base_color = {0.7f, 0.7f, 0.7f, 1}});
  scene.add_quad(grey, {0, 0, 0}, {0, 1, 0}, {12, 12});
  scene.add_box(grey, {0, 1.85f, 0}, {0.16f, 0.02f, 0.16f});
  scene.add_box(grey, {1.0f, 0.3f, 0.0f}, {0.3f, 0.6f, 0.3f});
  TestLight light = test_light("point", 0.08f);
  light.position = {0, 2, 0};
  scene.add_light(light);
  EXPECT_LT(flip_to_truth(scene.load(), request()), 0.06);  // 0.15 with the widest filter a quarter of this one
}

TEST(LocalShadows, ShadowsGoOnAcrossTheFacesOfAPoint) {
  GltfWriter scene = room();
  const int grey = scene.add_material({.base_color = {0.7f, 0.7f, 0.7f, 1}});
  const glm::vec3 light(0.3f, 0.2f, -0.4f);
  // Rods along the edges that faces meet at.
  for (const glm::vec3 way : {glm::vec3(1, 1, 0), glm::vec3(-1, 0, 1), glm::vec3(0, -1, -1), glm::vec3(1, 0, -1)})
    scene.add_box(grey, light + 0.5f * way, {0.25f, 0.2f, 0.15f});
  scene.add_light({.intensity = 10.0f, .position = light});
  const Scene loaded = scene.load();
  for (const auto& [eye, target] :
       {std::pair<std::array<float, 3>, std::array<float, 3>>{{-1.8f, 1.7f, 1.8f}, {1, -1, -1}},
        {{1.8f, 1.7f, 1.8f}, {-1, -0.5f, -1}}}) {
    RenderRequest view = request_from(eye, target);
    view.look_at->vertical_fov_deg = 80.0f;
    EXPECT_LT(flip_to_truth(loaded, view), 0.025);
  }
}

// Nothing stands between a light and the walls of the room that it is in.
TEST(LocalShadows, WallsDoNotShadowThemselves) {
  for (const float radius : {0.0f, 0.05f}) {
    GltfWriter scene = room();
    TestLight light{.intensity = 5.0f, .position = {0.7f, -0.9f, 1.1f}};
    if (radius > 0.0f) light.extras = {{"radius", radius}};
    scene.add_light(light);
    const Scene loaded = scene.load();
    RenderRequest view = request_from({-1.8f, 1.7f, 1.8f}, {1, -1, -1});
    view.look_at->vertical_fov_deg = 80.0f;
    view.settings.contact_shadows.enabled = false;  // of the maps alone
    const Picture lit = picture_of(loaded, without_shadows(view));
    EXPECT_LT(largest_error(picture_of(loaded, view).linear, lit.linear), 1e-6) << radius;
  }
}

// A floor under a light that hangs low is lit at all angles, up to 87 degrees.
TEST(LocalShadows, SurfacesAreLitAtEveryTilt) {
  for (const char* type : {"point", "spot"}) {
    GltfWriter scene;
    scene.add_quad(scene.add_material({}), {0, 0, 0}, {0.1f, 1, 0.05f}, {20, 20});
    TestLight light{.type = type, .intensity = 5.0f, .outer_cone = 1.55f, .position = {0, 0.5f, 0}};
    light.direction = {0.1f, -1, 0};
    scene.add_light(light);
    const Scene loaded = scene.load();
    const RenderRequest view = request_from({6, 6, 6}, {0, 0, 0});
    const Picture lit = picture_of(loaded, without_shadows(view));
    EXPECT_LT(largest_error(picture_of(loaded, view).linear, lit.linear), 1e-6) << type;
  }
}

Scene many_lamps() {
  GltfWriter scene = plane_with_boxes();
  for (int i = 0; i < 24; ++i) {
    TestLight light = test_light(i % 3 == 0 ? "spot" : "point", i % 2 == 0 ? 0.1f : 0.0f);
    light.intensity = 2.0f + static_cast<float>(i);
    light.position = {3.0f * std::cos(0.26f * static_cast<float>(i)), 1.8f,
                      3.0f * std::sin(0.26f * static_cast<float>(i))};
    light.direction = -light.position;
    scene.add_light(light);
  }
  return scene.load();
}

TEST(LocalShadows, TheSamePictureTwiceAndUnderFullBarriers) {
  const Scene scene = many_lamps();
  RenderRequest view = request();
  view.settings.frame.spp = 2;
  const Picture first = picture_of(scene, view), second = picture_of(scene, view);
  EXPECT_EQ(largest_error(first.linear, second.linear), 0.0);
  view.settings.frame.sync = Sync::paranoid;
  EXPECT_EQ(largest_error(first.linear, picture_of(scene, view).linear), 0.0);
}

// Shadows become coarse, then fewer: light is never brought in, and what has lost its shadows shines as without any.
TEST(LocalShadows, AFullAtlasNeverShowsGarbage) {
  const Scene scene = many_lamps();
  const Picture open = picture_of(scene, without_shadows(request())), full = picture_of(scene, request());
  RenderRequest small = request();
  small.settings.local_shadows.atlas = 256;
  const Picture picture = picture_of(scene, small);
  ASSERT_EQ(picture.linear.size(), open.linear.size());
  double sum = 0.0, sum_open = 0.0, sum_full = 0.0;
  for (std::size_t i = 0; i < picture.linear.size(); ++i) {
    ASSERT_LE(picture.linear[i], open.linear[i] * 1.001f + 1e-4f);
    sum += static_cast<double>(picture.linear[i]);
    sum_open += static_cast<double>(open.linear[i]);
    sum_full += static_cast<double>(full.linear[i]);
  }
  EXPECT_GT(sum, sum_full);
  EXPECT_LT(sum, sum_open);
}

TEST(LocalShadows, ALightInsideABodyLightsNothingOutside) {
  GltfWriter scene = plane_with_boxes();
  scene.add_light({.intensity = 40.0f, .position = {0, 0.5f, 0}});
  const Picture picture = picture_of(scene.load(), request());
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x) ASSERT_EQ(linear_at(picture, x, y).x, 0.0f) << x << ' ' << y;
}

TEST(LocalShadows, ExtremesAreFinite) {
  for (const float cone : {1e-5f, 0.6f, 1.5707f})
    for (const glm::vec3 place : {glm::vec3(3, 3, 4), glm::vec3(0, 0, 0), glm::vec3(0, 1e4f, 0)})
      for (const float radius : {0.0f, 5.0f}) {
        GltfWriter scene = plane_with_boxes();
        TestLight light = test_light("spot", radius);
        light.inner_cone = 0.0f;
        light.outer_cone = cone;
        light.position = place;
        light.range = place.y > 100.0f ? 0.0f : 1e-3f + 10.0f * cone;
        scene.add_light(light);
        EXPECT_TRUE(is_finite(picture_of(scene.load(), request())));
      }
}

}  // namespace
}  // namespace velarium::test
