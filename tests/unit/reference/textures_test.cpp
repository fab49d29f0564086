// What samplers read, against values worked out by hand.

#include "reference/textures.hpp"

#include "shading/host.hpp"

#include <gtest/gtest.h>

namespace velarium::reference {
namespace {

// Grey levels of a 4 x 2 picture, rows from the top.
scene::Scene ramp(const scene::Sampler& sampler) {
  scene::Scene scene;
  scene::Image image{.name = "ramp", .width = 4, .height = 2};
  for (const std::uint8_t grey : {0, 51, 102, 153, 204, 255, 0, 51})
    image.rgba.insert(image.rgba.end(), {grey, grey, grey, static_cast<std::uint8_t>(255 - grey)});
  scene.images.push_back(image);
  scene.textures.push_back({0, sampler});
  scene::Material m;
  m.base_color_texture.texture = 0;
  m.metallic_roughness_texture.texture = 0;
  scene.materials.push_back(m);
  return scene;
}

float read(const scene::Sampler& sampler, glm::vec2 uv, float lod = -1.0f, float choice = 0.0f) {
  const scene::Scene scene = ramp(sampler);
  const Textures textures(scene);
  return textures.bind(scene.materials[0].metallic_roughness_texture, false).sample(uv, lod, choice).x;
}

constexpr float kTolerance = 1e-6f;

TEST(Textures, LinearFilterMixesTheFourNearest) {
  EXPECT_NEAR(read({}, {0.375f, 0.25f}), 0.2f, kTolerance);  // the middle of a texel
  EXPECT_NEAR(read({}, {0.5f, 0.25f}), 0.3f, kTolerance);    // between 0.2 and 0.4
  EXPECT_NEAR(read({}, {0.5f, 0.5f}), (0.2f + 0.4f + 1.0f + 0.0f) / 4.0f, kTolerance);
}

TEST(Textures, WrapModesDecideWhatLiesBeyondTheEdge) {
  using enum scene::Wrap;
  const glm::vec2 edge(1.0f, 0.25f);  // between the last texel, 0.6, and what follows it
  EXPECT_NEAR(read({.wrap_u = repeat}, edge), 0.3f, kTolerance);
  EXPECT_NEAR(read({.wrap_u = clamp_to_edge}, edge), 0.6f, kTolerance);
  EXPECT_NEAR(read({.wrap_u = mirrored_repeat}, edge), 0.6f, kTolerance);
  const glm::vec2 second(1.375f, 0.25f);  // the second texel of the next copy: forwards or backwards
  EXPECT_NEAR(read({.wrap_u = repeat}, second), 0.2f, kTolerance);
  EXPECT_NEAR(read({.wrap_u = mirrored_repeat}, second), 0.4f, kTolerance);
  EXPECT_NEAR(read({.wrap_u = clamp_to_edge}, second), 0.6f, kTolerance);
  const glm::vec2 before(-0.625f, 0.25f);
  EXPECT_NEAR(read({.wrap_u = repeat}, before), 0.2f, kTolerance);
  EXPECT_NEAR(read({.wrap_u = mirrored_repeat}, before), 0.4f, kTolerance);
  EXPECT_NEAR(read({.wrap_u = clamp_to_edge}, before), 0.0f, kTolerance);
}

TEST(Textures, NearestFilterTakesTheTexelThatCovers) {
  const scene::Sampler nearest{.mag = scene::Filter::nearest};
  EXPECT_NEAR(read(nearest, {0.26f, 0.25f}), 0.2f, kTolerance);
  EXPECT_NEAR(read(nearest, {0.49f, 0.25f}), 0.2f, kTolerance);
  EXPECT_NEAR(read(nearest, {0.51f, 0.25f}), 0.4f, kTolerance);
}

TEST(Textures, SmallerMipsAreMeansAndChosenByTheirShare) {
  // 2 x 1: means of 0, 51, 204, 255 and of 102, 153, 0, 51, at 8 bits.
  EXPECT_NEAR(read({}, {0.25f, 0.5f}, 1.0f), 127.5f / 255.0f, 0.501f / 255.0f);
  EXPECT_NEAR(read({}, {0.75f, 0.5f}, 1.0f), 76.5f / 255.0f, 0.501f / 255.0f);
  EXPECT_EQ(read({}, {0.25f, 0.25f}, 0.3f, 0.69f), read({}, {0.25f, 0.25f}, 0.0f));
  EXPECT_EQ(read({}, {0.25f, 0.25f}, 0.3f, 0.71f), read({}, {0.25f, 0.25f}, 1.0f));
  const scene::Sampler by_nearest{.mip = scene::Filter::nearest};
  EXPECT_EQ(read(by_nearest, {0.25f, 0.25f}, 0.4f, 0.9f), read({}, {0.25f, 0.25f}, 0.0f));
  EXPECT_EQ(read(by_nearest, {0.25f, 0.25f}, 0.6f, 0.0f), read({}, {0.25f, 0.25f}, 1.0f));
  EXPECT_EQ(read({.mipmapped = false}, {0.25f, 0.25f}, 2.0f), read({}, {0.25f, 0.25f}, 0.0f));
  EXPECT_NEAR(read({}, {0.1f, 0.9f}, 99.0f), 102.0f / 255.0f, 1.5f / 255.0f);  // the mean of all
}

TEST(Textures, ColoursAreDecodedAndAlphaIsNot) {
  const scene::Scene scene = ramp({});
  const Textures textures(scene);
  const glm::vec4 texel =
      textures.bind(scene.materials[0].base_color_texture, true).sample({0.875f, 0.25f}, -1.0f, 0.0f);
  EXPECT_NEAR(texel.x, 0.318547f, 1e-6f);  // ((0.6 + 0.055) / 1.055)^2.4, IEC 61966-2-1
  EXPECT_NEAR(texel.w, 0.4f, kTolerance);
}

TEST(Textures, MipsOfColoursAverageLight) {
  scene::Scene scene;
  scene.images.push_back(
      {.name = "black and white", .width = 2, .height = 1, .rgba = {0, 0, 0, 255, 255, 255, 255, 255}});
  scene.textures.push_back({0, {}});
  scene.materials.emplace_back().base_color_texture.texture = 0;
  const Textures textures(scene);
  const float mean = textures.bind(scene.materials[0].base_color_texture, true).sample({0.5f, 0.5f}, 1.0f, 0.0f).x;
  EXPECT_NEAR(mean, 0.5f, 0.003f);  // code 188; averaged codes would give 0.216
}

// KHR_texture_transform: translate * rotate * scale.
TEST(Textures, TransformsMoveTheCoordinates) {
  scene::Scene scene = ramp({});
  scene::TextureRef& ref = scene.materials[0].base_color_texture;
  ref.offset = {0.25f, 0.5f};
  ref.scale = {0.5f, 2.0f};
  ref.rotation = shading::kHalfPi;
  const Textures textures(scene);
  const BoundTexture bound = textures.bind(ref, false);
  // (u, v) -> scaled (u / 2, 2 v) -> turned (2 v, -u / 2) -> moved.
  const glm::vec2 uv(0.5f, 0.0625f), expected(2.0f * 0.0625f + 0.25f, -0.25f + 0.5f);
  EXPECT_NEAR(bound.sample(uv, -1.0f, 0.0f).x, read({}, expected), 1e-5f);
  EXPECT_NEAR(bound.log2_texels_per_uv(), 1.5f, 1e-5f);  // half of log2 of 4 x 2 texels times the determinant 1
}

TEST(Textures, CoordinatesThatAreNoNumbersReadSomething) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (const float u : {nan, infinity, -infinity, 1e30f, -1e30f}) {
    EXPECT_TRUE(std::isfinite(read({}, {u, u}, 0.5f, 0.5f)));
    EXPECT_TRUE(std::isfinite(read({}, {0.5f, 0.5f}, u, 0.5f)));
  }
}

TEST(Textures, NoTextureIsWhite) {
  EXPECT_EQ(BoundTexture{}.sample({0.3f, 0.7f}, 2.0f, 0.5f), glm::vec4(1.0f));
}

}  // namespace
}  // namespace velarium::reference
