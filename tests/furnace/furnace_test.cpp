// A white furnace: under radiance 1 from everywhere, whatever absorbs nothing looks like the background.

#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::test {
namespace {

// Two steps of the half floats below 1 that pictures are kept in, 2^-11 each. The 8-bit steps of the G-buffer cancel:
// albedo 1 and f0 1 are codes, and where f0 is none, what the specular lobe gets more the diffuse light gets less.
constexpr float kTolerance = 1.0f / 1024.0f;

struct Range {
  float lowest, highest;
};

// Of all pixels and colour channels.
Range range_of(const Picture& picture) {
  Range range{picture.linear.at(0), picture.linear.at(0)};
  for (std::size_t i = 0; i < picture.linear.size(); ++i) {
    if (i % 4 == 3) continue;
    range.lowest = std::min(range.lowest, picture.linear[i]);
    range.highest = std::max(range.highest, picture.linear[i]);
  }
  return range;
}

void expect_uniform(const Picture& picture, float radiance) {
  const Range range = range_of(picture);
  EXPECT_GE(range.lowest, radiance * (1.0f - kTolerance));
  EXPECT_LE(range.highest, radiance * (1.0f + kTolerance));
}

constexpr std::uint32_t kWidth = 320, kHeight = 180;

// builtin:furnace: four rows of spheres (metal, full reflectance by index of refraction, half metal, white paint) of
// perceptual roughness 0, 0.2 .. 1 from left to right.
enum Row { kMetal, kFullReflectance, kHalfMetal, kPaint };

RenderRequest furnace_request() {
  RenderRequest request = linear_request(kWidth, kHeight);
  request.environment = "white";
  return request;
}

Picture furnace(const RenderRequest& request) {
  return picture_of(Scene::load("builtin:furnace"), request);
}

// Red channel in the middle of a sphere. The scene's camera: 12 m before the grid of one metre, 19.5 degrees high.
float middle_of(const Picture& picture, int column, Row row) {
  const float pixels_per_metre = 0.5f * kHeight / (12.0f * std::tan(glm::radians(0.5f * 19.5f)));
  const float x = 0.5f * kWidth + pixels_per_metre * (static_cast<float>(column) - 2.5f);
  const float y = 0.5f * kHeight + pixels_per_metre * (static_cast<float>(row) - 1.5f);
  return linear_at(picture, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)).r;
}

TEST(Furnace, WhiteSpheresVanish) {
  const Picture picture = furnace(furnace_request());
  EXPECT_EQ(linear_at(picture, 0, 0), glm::vec4(1.0f)) << "the background itself";
  expect_uniform(picture, 1.0f);
}

TEST(Furnace, WhiteSpheresVanishAtAnyIntensityAndRotation) {
  RenderRequest request = furnace_request();
  request.settings.environment.intensity = 4.0f;
  request.settings.environment.rotation = 33.0f;
  expect_uniform(furnace(request), 4.0f);
}

TEST(Furnace, WhiteSpheresVanishInSphericalHarmonics) {
  RenderRequest request = furnace_request();
  request.settings.environment.diffuse = DiffuseEnvironment::sh;
  expect_uniform(furnace(request), 1.0f);
}

// A single bounce on a perfect metal of alpha 1 returns 1 - mu ln((1 + mu) / mu) of a uniform light, mu = n.v: the
// integral of D Vis n.l with D = 1 / pi and the height-correlated Vis = 1 / (2 (n.l + mu)). Least head-on: 1 - ln 2.
TEST(Furnace, SingleScatteringLosesWhatTheIntegralSays) {
  RenderRequest request = furnace_request();
  request.settings.lighting.multi_scatter = false;
  const Picture picture = furnace(request);
  // The table's own error, 1e-3, and the 8-bit steps of smoothness and normals.
  constexpr float kTableError = 0.005f;
  EXPECT_NEAR(range_of(picture).lowest, 1.0f - std::log(2.0f), kTableError);
  for (const Row row : {kMetal, kFullReflectance}) {
    EXPECT_NEAR(middle_of(picture, 5, row), 1.0f - std::log(2.0f), kTableError) << "row " << row;
    EXPECT_NEAR(middle_of(picture, 0, row), 1.0f, kTableError) << "row " << row;
    for (int column = 1; column < 6; ++column)
      EXPECT_LT(middle_of(picture, column, row), middle_of(picture, column - 1, row)) << "row " << row;
  }
  // What the specular lobe does not return, the diffuse light of a paint does.
  EXPECT_NEAR(middle_of(picture, 5, kPaint), 1.0f, kTolerance);
}

TEST(Furnace, TransparentWhiteSurfacesVanish) {
  GltfWriter scene;
  for (int i = 0; i < 6; ++i) {
    const float step = static_cast<float>(i);
    const int material = scene.add_material({.base_color = {1, 1, 1, i % 2 == 0 ? 1.0f : 0.5f},
                                             .metallic = i < 3 ? 0.0f : 1.0f,
                                             .perceptual_roughness = 0.2f * step,
                                             .specular = 1.0f,
                                             .alpha_mode = "BLEND"});
    scene.add_quad(material, {step - 2.5f, 0, 0}, {0.3f, 0.2f * step - 0.5f, 1}, {0.9f, 2.0f});
  }
  RenderRequest request = furnace_request();
  request.look_at = LookAt{.eye = {0, 0, 6}};
  const Picture picture = picture_of(scene.load(), request);
  expect_uniform(picture, 1.0f);
}

}  // namespace
}  // namespace velarium::test
