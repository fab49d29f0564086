// Lights drawn as bodies, one after the other, against lights found by tiles: the same sum, found in another way.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"

#include <velarium/compare.hpp>
#include <velarium/reference.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace velarium::test {
namespace {

// Both ways add the same numbers in the same order in fp32, and round the sum to half floats once. Where a compiler
// fuses an addition on one way alone, that rounding may end one step apart: 2^-10 of the value.
void expect_same_light(const Picture& a, const Picture& b) {
  ASSERT_EQ(a.linear.size(), b.linear.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < a.linear.size(); ++i) {
    const double larger = std::max({std::abs(a.linear[i]), std::abs(b.linear[i]), 1e-4f});
    worst = std::max(worst, std::abs(double{a.linear[i]} - b.linear[i]) / larger);
  }
  EXPECT_LE(worst, std::exp2(-10.0));
}

RenderRequest volumes(RenderRequest request) {
  request.settings.lighting.path = LightingPath::volumes;
  return request;
}

// Suns, lights with and without an end, narrow and wide spots, a pane of glass, and a floor that meets them all.
Scene mixed_lights() {
  GltfWriter scene;
  const int floor =
      scene.add_material({.base_color = {0.6f, 0.6f, 0.6f, 1}, .perceptual_roughness = 0.4f, .specular = 1.0f});
  scene.add_quad(floor, {0, 0, 0}, {0, 1, 0}, {14, 14});
  for (const float x : {-3.0f, 0.0f, 3.0f}) scene.add_box(floor, {x, 0.6f, -0.5f * x}, {1.0f, 1.2f, 0.8f});
  const int unlit = scene.add_material({.base_color = {0.2f, 0.3f, 0.4f, 1}, .unlit = true});
  scene.add_quad(unlit, {1.5f, 0.5f, 1}, {0, 0, 1}, {0.5f, 0.5f});
  const int glass = scene.add_material({.base_color = {0.3f, 0.6f, 0.5f, 0.4f},
                                        .perceptual_roughness = 0.3f,
                                        .specular = 1.0f,
                                        .double_sided = true,
                                        .alpha_mode = "BLEND"});
  scene.add_quad(glass, {0, 1, 2}, {0.2f, 0.1f, 1}, {4, 2});
  for (int i = 0; i < 40; ++i) {
    const float turn = 2.4f * static_cast<float>(i), far = 0.9f * std::sqrt(static_cast<float>(i));
    TestLight light{.intensity = 0.4f,
                    .color = {0.3f + 0.7f * static_cast<float>(i % 3 == 0), 0.6f, 0.9f},
                    .range = 0.3f + 0.4f * static_cast<float>(i % 5) + (i % 11 == 0 ? 6.0f : 0.0f),
                    .position = {far * std::cos(turn), 0.3f + 0.2f * static_cast<float>(i % 6), far * std::sin(turn)}};
    if (i % 2 == 0) {
      light.type = "spot";
      light.direction = {0.3f * std::cos(turn), -1.0f, 0.3f * std::sin(turn)};
      light.inner_cone = 0.1f;
      light.outer_cone = 0.2f + 0.15f * static_cast<float>(i % 9);
      light.range += 1.0f;
    }
    scene.add_light(light);
  }
  scene.add_light({.intensity = 0.5f, .position = {0, 3, 0}});
  scene.add_light({.type = "directional", .intensity = 0.2f, .direction = {-0.3f, -1, -0.5f}});
  scene.add_light({.type = "directional", .intensity = 0.1f, .direction = {0.7f, -1, -0.2f}});
  scene.add_orthographic_camera({6, 5, 7}, {0, 0, 0}, 4.0f, 30.0f);
  return scene.load();
}

RenderRequest two_frames(std::uint32_t width, std::uint32_t height) {
  RenderRequest request;
  request.width = width;
  request.height = height;
  request.settings.frame.spp = 2;
  request.want_display = false;
  return request;
}

// From afar lights are quads, from nearer bodies; in their midst most hold the eye.
TEST(LightVolumes, GiveThePictureOfTiles) {
  const Scene scene = mixed_lights();
  RenderRequest orthographic = two_frames(157, 101), far = orthographic, near = orthographic, within = orthographic;
  far.look_at = LookAt{.eye = {12, 18, 24}, .target = {0, 0, 0}, .vertical_fov_deg = 40.0f};
  near.look_at = LookAt{.eye = {3.0f, 1.8f, 4.5f}, .target = {0, 0.4f, 0}, .vertical_fov_deg = 60.0f};
  within.look_at = LookAt{.eye = {0.1f, 0.9f, 0.8f}, .target = {-1, 0.2f, -3}, .vertical_fov_deg = 90.0f};
  for (const RenderRequest& request : {orthographic, far, near, within}) {
    SCOPED_TRACE(request.look_at ? request.look_at->eye[1] : 0.0f);
    const auto drawn = engine().render(scene, volumes(request));
    EXPECT_GT(passes_named(drawn.report, "light_volumes"), 0u);
    expect_same_light(picture_of(scene, request), drawn.picture);
  }
}

TEST(LightVolumes, GiveThePictureOfTilesInScenesOfEveryKind) {
  const auto data = std::filesystem::path(VELARIUM_TEST_DATA);
  for (const auto& name : {data / "lights.gltf", std::filesystem::path("builtin:atrium?sun=off&lights=24")}) {
    SCOPED_TRACE(name);
    const Scene scene = Scene::load(name);
    const RenderRequest request = two_frames(80, 60);
    expect_same_light(picture_of(scene, request), picture_of(scene, volumes(request)));
  }
}

// All that stands between a light and a point, of each kind of light: shadows with and without penumbrae, a sheet that
// dyes them, a volume that some lights end at.
Scene lights_behind_things() {
  GltfWriter scene;
  const int grey = scene.add_material({.base_color = {0.7f, 0.7f, 0.7f, 1}, .double_sided = true});
  scene.add_quad(grey, {0, 0, 0}, {0, 1, 0}, {8, 8});
  scene.add_box(grey, {-0.8f, 0.5f, 0}, {0.6f, 1, 0.6f});
  scene.add_box(grey, {0.7f, 0.9f, -0.4f}, {0.9f, 0.05f, 0.5f});
  const int red =
      scene.add_material({.base_color = {0.8f, 0.2f, 0.1f, 0.6f}, .double_sided = true, .alpha_mode = "BLEND"});
  scene.add_quad(red, {0.2f, 1.1f, 0.6f}, {0.2f, 1, 0.1f}, {1.2f, 0.8f});
  scene.add_clip_box("left", {-2, 2, 0}, {2, 4, 4});
  for (const char* type : {"point", "spot"})
    for (const float radius : {0.0f, 0.12f})
      for (const bool ends : {false, true}) {
        TestLight light{.type = type,
                        .intensity = 4.0f,
                        .range = 7.0f,
                        .inner_cone = 0.3f,
                        .outer_cone = 0.6f,
                        .position = {ends ? -1.5f : 1.3f, 2.4f, radius > 0.0f ? 1.2f : -1.0f}};
        light.direction = -light.position;
        light.extras = {{"casts_shadow", true}};
        if (radius > 0.0f) light.extras["radius"] = radius;
        if (ends) light.extras["clip_volume"] = "left";
        scene.add_light(light);
      }
  scene.add_light({.type = "directional",
                   .intensity = 1.0f,
                   .direction = {-0.4f, -1, -0.3f},
                   .extras = {{"angular_radius", 0.03f}}});
  return scene.load();
}

TEST(LightVolumes, SeeWhatStandsBeforeTheirLight) {
  const Scene scene = lights_behind_things();
  RenderRequest request = linear_request(80, 60);
  request.look_at = LookAt{.eye = {2.5f, 3.0f, 4.0f}, .target = {0, 0.3f, 0}};
  const Picture drawn = picture_of(scene, volumes(request));
  expect_same_light(picture_of(scene, request), drawn);
  // There is much of that in the picture.
  set_options(request.settings, "local_shadows.enabled=off sun_shadows.enabled=off");
  EXPECT_GT(largest_error(picture_of(scene, volumes(request)).linear, drawn.linear), 0.1);
}

TEST(LightVolumes, NeedNoMoreBarriersThanTheySay) {
  const Scene scene = mixed_lights();
  RenderRequest request = volumes(two_frames(80, 60));
  request.look_at = LookAt{.eye = {0.1f, 0.9f, 0.8f}, .target = {-1, 0.2f, -3}, .vertical_fov_deg = 90.0f};
  const Picture normal = picture_of(scene, request);
  request.settings.frame.sync = Sync::paranoid;
  EXPECT_EQ(largest_error(normal.linear, picture_of(scene, request).linear), 0.0);
}

TEST(LightVolumes, AreNotDrawnWhereNoLightShines) {
  const auto report = engine().render(Scene::load("builtin:furnace"), volumes(two_frames(32, 24))).report;
  EXPECT_EQ(passes_named(report, "light_volumes"), 0u);
}

// The legacy model in both renderers: highlights under lights alone, of which the path tracer has no noise.
TEST(BlinnPhong, IsThatOfThePathTracer) {
  GltfWriter writer;
  for (const float x : {-1.5f, 0.0f, 1.5f}) {
    const int metal = writer.add_material(
        {.base_color = {0.9f, 0.7f, 0.4f, 1}, .metallic = 1.0f, .perceptual_roughness = 0.5f + 0.2f * x});
    writer.add_quad(metal, {x, 0, 0}, {0.1f * x, 1, 0.3f}, {1.4f, 3});
  }
  writer.add_light({.type = "directional", .intensity = 2.0f, .direction = {0, -1, -0.6f}});
  writer.add_light({.intensity = 3.0f, .position = {0.5f, 1.5f, -1}});
  const Scene scene = writer.load();
  ReferenceRequest request{.view = linear_request(96, 64)};
  request.view.look_at = LookAt{.eye = {0, 3, 3}, .vertical_fov_deg = 45.0f};
  request.view.settings.frame.spp = 16;
  request.view.settings.reference.spp = 64;
  request.view.settings.reference.transport = Transport::direct;
  // Nothing stands in the way of these lights; where a driver's rounding has maps say otherwise is not asked here.
  request.view.settings.reference.shadows = false;
  request.view.settings.local_shadows.enabled = request.view.settings.sun_shadows.enabled = false;
  request.view.settings.lighting.model = ShadingModel::blinn_phong;
  const Picture traced = render_reference(scene, request).picture;
  const Picture drawn = picture_of(scene, request.view);
  request.view.settings.lighting.model = ShadingModel::gltf;
  EXPECT_LT(compare(drawn, traced).flip, 0.03);  // what 8 bits of the G-buffer and edges leave, of any model
  EXPECT_GT(compare(picture_of(scene, request.view), traced).flip, 0.06);
}

}  // namespace
}  // namespace velarium::test
