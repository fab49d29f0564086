// Lights that multiply what surrounds a point, in pictures of a floor under white surroundings.

#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::test {
namespace {

struct AmbientLight {
  glm::vec3 color{1.0f};
  float range = 1e6f;  // so far that all of the scene is at its centre
  glm::vec3 center{0.0f};
};

const TestMaterial kMatt{.base_color = {0.8f, 0.6f, 0.4f, 1.0f}};
const TestMaterial kMetal{.base_color = {0.9f, 0.7f, 0.5f, 1.0f}, .metallic = 1.0f, .perceptual_roughness = 0.3f};
const TestMaterial kPlastic{.base_color = {0.5f, 0.5f, 0.5f, 1.0f}, .perceptual_roughness = 0.2f, .specular = 1.0f};

// A floor of four metres about the origin, and a wall at its back.
GltfWriter room(const TestMaterial& material, const std::vector<AmbientLight>& lights) {
  GltfWriter scene;
  const int paint = scene.add_material(material);
  scene.add_quad(paint, {0, 0, 0}, {0, 1, 0}, {4, 4});
  scene.add_quad(paint, {0, 1, -2}, {0, 0, 1}, {4, 2});
  for (const auto& light : lights) scene.add_ambient_light(light.center, light.color, light.range);
  return scene;
}

RenderRequest request() {
  RenderRequest request = linear_request(48, 32);
  request.environment = "studio";
  request.look_at = LookAt{.eye = {0.5f, 1.5f, 3.0f}, .target = {0.0f, 0.4f, -1.0f}, .vertical_fov_deg = 50.0f};
  return request;
}

Picture lit_by(const std::vector<AmbientLight>& lights, const TestMaterial& material = kMatt) {
  return picture_of(room(material, lights).load(), request());
}

constexpr std::uint32_t kFloorX = 24, kFloorY = 26, kWallX = 24, kWallY = 12;

TEST(AmbientLights, OfColor1ChangeNoBit) {
  const AmbientLight near{.color = glm::vec3(1.0f), .range = 1.5f};
  for (const TestMaterial& material : {kMatt, kMetal, kPlastic})
    EXPECT_EQ(lit_by({near}, material).linear, lit_by({}, material).linear);
}

TEST(AmbientLights, ThatAreOffChangeNoBit) {
  RenderRequest off = request();
  off.settings.ambient_lights.enabled = false;
  const AmbientLight dark{.color = glm::vec3(0.2f)};
  EXPECT_EQ(picture_of(room(kPlastic, {dark}).load(), off).linear, lit_by({}, kPlastic).linear);
  EXPECT_NE(lit_by({dark}, kPlastic).linear, lit_by({}, kPlastic).linear);
}

// Halving is exact in half floats, which the picture is kept in.
TEST(AmbientLights, HalveDiffuseAndSpecularLight) {
  for (const TestMaterial& material : {kMatt, kMetal, kPlastic}) {
    const Picture whole = lit_by({}, material), half = lit_by({{.color = glm::vec3(0.5f)}}, material);
    for (const auto [x, y] : {std::pair{kFloorX, kFloorY}, {kWallX, kWallY}})
      EXPECT_EQ(glm::vec3(linear_at(half, x, y)), 0.5f * glm::vec3(linear_at(whole, x, y)));
  }
}

TEST(AmbientLights, LeaveTheBackgroundAlone) {
  const Picture whole = lit_by({}), dark = lit_by({{.color = glm::vec3(0.0f)}});
  EXPECT_EQ(linear_at(dark, 0, 0), linear_at(whole, 0, 0));
  EXPECT_GT(linear_at(dark, 0, 0).g, 0.0f);
  EXPECT_EQ(linear_at(dark, kFloorX, kFloorY), glm::vec4(0, 0, 0, 1));
}

// Whatever a material makes of its surroundings, an ambient light multiplies by the same: the ratio of what reflects to
// what scatters stays.
TEST(AmbientLights, KeepTheRatioOfReflectances) {
  const AmbientLight dye{.color = {0.3f, 1.7f, 2.5f}, .range = 4.0f, .center = {0.4f, 0.8f, -0.5f}};
  const auto gain = [&](const TestMaterial& material, std::uint32_t x, std::uint32_t y) {
    return glm::vec3(linear_at(lit_by({dye}, material), x, y)) / glm::vec3(linear_at(lit_by({}, material), x, y));
  };
  for (const auto [x, y] : {std::pair{kFloorX, kFloorY}, {kWallX, kWallY}}) {
    const glm::vec3 matt = gain(kMatt, x, y);
    EXPECT_LT(matt.r, 0.9f);
    EXPECT_GT(matt.b, 1.1f);
    // Each of the two pictures rounds to half floats, 2^-11.
    for (const TestMaterial& material : {kMetal, kPlastic})
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(gain(material, x, y)[c] / matt[c], 1.0f, 0.003f);
  }
}

TEST(AmbientLights, OrderDoesNotMatter) {
  const AmbientLight a{.color = {0.3f, 1.5f, 0.8f}, .range = 3.0f}, b{.color = {2.0f, 0.5f, 1.0f}, .range = 2.5f};
  EXPECT_EQ(lit_by({a, b}).linear, lit_by({b, a}).linear);
}

TEST(AmbientLights, LeaveOtherLightsAlone) {
  GltfWriter with = room(kPlastic, {{.color = glm::vec3(0.0f)}}), without = room(kPlastic, {});
  for (GltfWriter* scene : {&with, &without}) scene->add_light({.intensity = 5.0f, .position = {0, 1, 0}});
  RenderRequest dark = request();
  dark.environment = "none";
  EXPECT_EQ(picture_of(with.load(), dark).linear, picture_of(without.load(), dark).linear);
}

// As many as a scene may have, and so many other lights that loops of a software driver would end early in the last row
// of a tile if these were not counted (kMaxLoopIterations in lighting.cpp).
TEST(AmbientLights, CountAmongLoops) {
  constexpr int kAmbientLights = 256, kLights = 3900;
  constexpr std::uint32_t kX = 24, kLastRow = 31;
  const auto picture = [](int ambient_lights, LightingPath path) {
    GltfWriter scene = room(kMatt, std::vector<AmbientLight>(static_cast<std::size_t>(ambient_lights),
                                                             AmbientLight{.color = glm::vec3(0.99f)}));
    for (int i = 0; i < kLights; ++i) scene.add_light({.intensity = 1e-3f, .position = {0, 1, 0}});
    RenderRequest all = request();
    all.settings.lighting.path = path;
    all.settings.local_shadows.enabled = false;
    return linear_at(picture_of(scene.load(), all), kX, kLastRow).g;
  };
  RenderRequest environment = request();
  environment.settings.lighting.punctual = false;
  const float surroundings = linear_at(picture_of(room(kMatt, {}).load(), environment), kX, kLastRow).g;
  const float lights = picture(0, LightingPath::tiled) - surroundings;
  ASSERT_GT(lights, 0.1f);
  for (const auto path : {LightingPath::tiled, LightingPath::all})
    EXPECT_NEAR(picture(kAmbientLights, path), surroundings * std::pow(0.99f, kAmbientLights) + lights, 0.002f);
}

TEST(AmbientLights, ReachBlendedSurfaces) {
  TestMaterial glass = kMatt;
  glass.alpha_mode = "BLEND";
  const Picture whole = lit_by({}, glass), half = lit_by({{.color = glm::vec3(0.5f)}}, glass);
  const glm::vec3 expected = 0.5f * glm::vec3(linear_at(whole, kFloorX, kFloorY));
  EXPECT_GT(expected.g, 0.0f);
  EXPECT_EQ(glm::vec3(linear_at(half, kFloorX, kFloorY)), expected);
}

}  // namespace
}  // namespace velarium::test
