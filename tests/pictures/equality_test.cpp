// Pictures that must be equal to the bit: a frame is a pure function of scene, view, time and settings.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace velarium::test {
namespace {

// Both halves of the picture, with two frames, so that jitter, sums and dither take part.
RenderRequest request(std::uint32_t width, std::uint32_t height) {
  RenderRequest request;
  request.width = width;
  request.height = height;
  request.settings.frame.spp = 2;
  return request;
}

Scene data(const char* name) {
  return Scene::load(std::filesystem::path(VELARIUM_TEST_DATA) / name);
}

void expect_equal(const Picture& a, const Picture& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(largest_error(a.linear, b.linear), 0.0);
  EXPECT_TRUE(a.display == b.display);
}

// 1232 lights over a floor with boxes and panes of glass: points and spots that end, eight points and two spots that
// do not, four suns.
class ManyLights {
 public:
  ManyLights() {
    add_surfaces();
    for (int z = 0; z < kRows; ++z)
      for (int x = 0; x < kColumns; ++x) add_short_light(x, z);
    for (int i = 0; i < 8; ++i) {
      const float turn = 0.785f * static_cast<float>(i);
      scene_.add_light({.intensity = 0.4f, .position = {4.0f * std::cos(turn), 2.5f, 4.0f * std::sin(turn)}});
    }
    for (const float x : {-2.0f, 2.0f})
      scene_.add_light({.type = "spot",
                        .intensity = 3.0f,
                        .inner_cone = 0.3f,
                        .outer_cone = 0.5f,
                        .position = {x, 4.0f, 0.0f},
                        .direction = {-0.2f * x, -1.0f, 0.1f}});
    for (const float x : {-1.0f, -0.3f, 0.4f, 1.0f})
      scene_.add_light({.type = "directional", .intensity = 0.2f, .direction = {x, -1.0f, -0.5f}});
    scene_.add_orthographic_camera({6, 5, 7}, {0, 0, 0}, 4.0f, 30.0f);
  }

  [[nodiscard]] Scene load() const { return scene_.load(); }

 private:
  static constexpr int kColumns = 42, kRows = 29;

  void add_surfaces() {
    const int floor =
        scene_.add_material({.base_color = {0.6f, 0.6f, 0.6f, 1}, .perceptual_roughness = 0.5f, .specular = 1.0f});
    scene_.add_quad(floor, {0, 0, 0}, {0, 1, 0}, {14, 14});
    const int copper =
        scene_.add_material({.base_color = {0.95f, 0.64f, 0.54f, 1}, .metallic = 1.0f, .perceptual_roughness = 0.4f});
    for (const float x : {-3.0f, 0.0f, 3.0f}) scene_.add_box(copper, {x, 0.6f, -0.5f * x}, {1.0f, 1.2f, 0.8f});
    const int glass = scene_.add_material({.base_color = {0.3f, 0.6f, 0.5f, 0.4f},
                                           .perceptual_roughness = 0.3f,
                                           .specular = 1.0f,
                                           .double_sided = true,
                                           .alpha_mode = "BLEND"});
    for (const float z : {-2.0f, 1.0f, 2.5f}) scene_.add_quad(glass, {0.4f * z, 1.0f, z}, {0.2f, 0.1f, 1}, {5, 2});
  }

  void add_short_light(int x, int z) {
    const int index = z * kColumns + x;
    const float u = static_cast<float>(x) / (kColumns - 1) - 0.5f, v = static_cast<float>(z) / (kRows - 1) - 0.5f;
    TestLight light{
        .intensity = 0.1f,
        .color = {0.3f + 0.7f * static_cast<float>(index % 3 == 0), 0.4f + 0.6f * static_cast<float>(index % 2), 0.8f},
        .range = 0.5f + 0.25f * static_cast<float>(index % 5),
        .position = {12.0f * u, 0.2f + 0.3f * static_cast<float>(index % 7), 12.0f * v}};
    if (index % 4 == 0) {
      light.type = "spot";
      light.direction = {u, -1.0f, v};
      light.inner_cone = 0.2f;
      light.outer_cone = 0.3f + 0.1f * static_cast<float>(index % 10);
    }
    scene_.add_light(light);
  }

  GltfWriter scene_;
};

TEST(Determinism, TwoRunsGiveEqualBytes) {
  const Scene scene = Scene::load("builtin:spheres");
  const Picture first = picture_of(scene, request(96, 54));
  expect_equal(first, picture_of(scene, request(96, 54)));
  EXPECT_GT(largest_error(first.linear, picture_of(data("triangle.gltf"), request(96, 54)).linear), 0.0);
}

TEST(Determinism, TwoEnginesGiveEqualBytes) {
  const Scene scene = data("blend_layers.gltf");
  Engine other(validated());
  expect_equal(picture_of(scene, request(96, 54)), other.picture(scene, request(96, 54)));
}

TEST(Determinism, WhatWasRenderedBeforeLeavesNoTrace) {
  const Scene bar = data("skinned_bar.gltf");
  RenderRequest bent = request(70, 50), later = bent, masked = request(33, 47);
  later.time_s = 1.0f;
  masked.settings.display.exposure_mode = ExposureMode::automatic;
  const Picture first = picture_of(bar, bent);
  const Picture straight = picture_of(bar, later);
  EXPECT_GT(largest_error(first.linear, straight.linear), 0.0);
  const Picture screen = picture_of(data("mirrored_and_masked.gltf"), masked);
  (void)picture_of(data("lights.gltf"), request(128, 16));
  (void)picture_of(Scene::load("builtin:furnace"), request(16, 128));
  expect_equal(screen, picture_of(data("mirrored_and_masked.gltf"), masked));
  expect_equal(straight, picture_of(bar, later));
  expect_equal(first, picture_of(bar, bent));
}

TEST(Barriers, ParanoidOnesChangeNothing) {
  for (const char* name : {"blend_layers.gltf", "lights.gltf", "mirrored_and_masked.gltf", "morph_cube.gltf"}) {
    SCOPED_TRACE(name);
    RenderRequest normal = request(80, 60);
    normal.settings.display.exposure_mode = ExposureMode::automatic;
    RenderRequest paranoid = normal;
    paranoid.settings.frame.sync = Sync::paranoid;
    expect_equal(picture_of(data(name), normal), picture_of(data(name), paranoid));
  }
}

// Sizes that are no multiple of the tiles; seen from near by, so that tiles hold near and far surfaces.
TEST(TiledLighting, EqualsEveryLightAtEveryPixel) {
  const Scene scene = ManyLights().load();
  ASSERT_GE(scene.info().lights.size(), 1024u);
  RenderRequest tiled = request(157, 101);
  tiled.look_at = LookAt{.eye = {3.0f, 1.8f, 4.5f}, .target = {0, 0.4f, 0}, .vertical_fov_deg = 60.0f};
  RenderRequest orthographic = request(157, 101);
  for (RenderRequest view : {tiled, orthographic}) {
    const Picture culled = picture_of(scene, view);
    view.settings.lighting.path = LightingPath::all;
    expect_equal(culled, picture_of(scene, view));
  }
}

// BLEND surfaces read the lists that the tiled pass leaves them; opaque ones do not. At alpha 1 both must agree but for
// the 8-bit steps of the G-buffer: this plane faces a code, its albedo is 1, and it is matt.
TEST(TiledLighting, TransparentSurfacesFindTheSameLights) {
  const auto plane = [](const char* alpha_mode) {
    GltfWriter scene;
    scene.add_quad(scene.add_material({.alpha_mode = alpha_mode}), {0, 0, 0}, {1, 1, 1}, {20, 20});
    for (int i = 0; i < 300; ++i) {
      const float turn = 2.4f * static_cast<float>(i), far = 0.25f * std::sqrt(static_cast<float>(i));
      const glm::vec3 on_plane(far * std::cos(turn), far * std::sin(turn), -far * (std::cos(turn) + std::sin(turn)));
      scene.add_light({.intensity = 0.2f, .range = 1.5f, .position = on_plane + 0.3f});
    }
    return scene.load();
  };
  RenderRequest view = linear_request(121, 83);
  view.look_at = LookAt{.eye = {3, 1, 2}};
  // Maps are read at positions that the two round differently.
  view.settings.local_shadows.enabled = false;
  const Picture opaque = picture_of(plane("OPAQUE"), view), blended = picture_of(plane("BLEND"), view);
  // One step of a half float each, below the next power of two.
  EXPECT_LT(largest_error(opaque.linear, blended.linear), 4e-3);
  float most_red = 0.0f;  // alpha is 1 without light as well
  for (std::size_t i = 0; i < opaque.linear.size(); i += 4) most_red = std::max(most_red, opaque.linear[i]);
  EXPECT_GT(most_red, 0.1f);
}

TEST(Sizes, AnySizeAndNumberOfFramesMakesAPicture) {
  struct Case {
    std::uint32_t width, height;
    int spp;
  };
  for (const Case& c : {Case{17, 9, 1}, Case{1, 1, 2}, Case{1000, 3, 5}, Case{3, 1000, 1}, Case{16, 16, 3}}) {
    SCOPED_TRACE(testing::Message() << c.width << "x" << c.height << " spp " << c.spp);
    RenderRequest view = request(c.width, c.height);
    view.settings.frame.spp = c.spp;
    std::uint32_t frames = 0;
    view.on_frame = [&](std::uint32_t done, std::uint32_t of) {
      EXPECT_EQ(done, ++frames);
      EXPECT_EQ(of, static_cast<std::uint32_t>(c.spp));
    };
    const Picture picture = picture_of(Scene::load("builtin:spheres"), view);
    EXPECT_EQ(frames, static_cast<std::uint32_t>(c.spp));
    ASSERT_EQ(picture.linear.size(), std::size_t{4} * c.width * c.height);
    ASSERT_EQ(picture.display.size(), picture.linear.size());
    for (std::size_t i = 0; i < picture.linear.size(); ++i) {
      ASSERT_TRUE(std::isfinite(picture.linear[i])) << i;
      ASSERT_TRUE(i % 4 != 3 || picture.linear[i] == 1.0f) << i;
    }
  }
}

// A small picture is no crop of a large one, but its middle looks at the same point: here at one flat colour.
TEST(Sizes, TheMiddleStaysInTheMiddle) {
  GltfWriter scene;
  const TestMaterial red{.base_color = {1, 0, 0, 1}, .unlit = true}, blue{.base_color = {0, 0, 1, 1}, .unlit = true};
  scene.add_quad(scene.add_material(red), {0, 0, 0}, {0, 0, 1}, {0.5f, 0.5f});
  scene.add_quad(scene.add_material(blue), {0, 0, -1}, {0, 0, 1}, {40, 40});
  const Scene target = scene.load();
  for (const auto& [width, height] : {std::pair{17u, 9u}, {1u, 1u}, {1001u, 3u}, {64u, 64u}}) {
    RenderRequest view = linear_request(width, height);
    view.look_at = LookAt{.eye = {0, 0, 1}, .vertical_fov_deg = 90.0f};
    const Picture picture = picture_of(target, view);
    EXPECT_EQ(linear_at(picture, width / 2, height / 2), glm::vec4(1, 0, 0, 1)) << width << "x" << height;
    const glm::vec4 top = height > 1 ? glm::vec4(0, 0, 1, 1) : glm::vec4(1, 0, 0, 1);
    EXPECT_EQ(linear_at(picture, width / 2, 0), top) << width << "x" << height;
  }
}

}  // namespace
}  // namespace velarium::test
