#include "upload/projectors.hpp"

#include <gtest/gtest.h>

namespace velarium::upload {
namespace {

using Color = std::array<std::uint8_t, 4>;

constexpr Color kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kWhite{255, 255, 255, 255}, kClear{255, 255, 255, 0};

scene::Image picture(std::uint32_t width, std::uint32_t height, const std::vector<Color>& texels) {
  scene::Image image{.width = width, .height = height};
  for (const Color& texel : texels) image.rgba.insert(image.rgba.end(), texel.begin(), texel.end());
  return image;
}

scene::Light thrower(std::int32_t image, float soft_edge) {
  return {.kind = scene::LightKind::spot, .projector = {.image = image, .field_of_view = 1.0f, .soft_edge = soft_edge}};
}

// At shares of the layer's width and height.
Color texel(const scene::Image& layer, float u, float v) {
  const auto x = static_cast<std::size_t>(u * static_cast<float>(layer.width));
  const auto y = static_cast<std::size_t>(v * static_cast<float>(layer.height));
  Color color;
  std::copy_n(&layer.rgba[4 * (y * layer.width + x)], 4, color.begin());
  return color;
}

scene::Image only_layer(const scene::Scene& scene) {
  const auto pictures = projector_pictures(scene);
  const auto layers = projector_layers(scene, pictures);
  EXPECT_EQ(layers.size(), 1u);
  return layers.at(0);
}

TEST(Projectors, PicturesAreSharedByLightsThatDifferInTheirFieldAlone) {
  scene::Scene scene;
  scene.lights = {thrower(0, 0.1f), thrower(0, 0.1f), {}, thrower(0, 0.2f), thrower(1, 0.1f)};
  scene.lights[1].projector.field_of_view = 0.3f;
  const auto pictures = projector_pictures(scene);
  ASSERT_EQ(pictures.size(), 3u);
  EXPECT_EQ(projector_layer(scene.lights[1].projector, pictures), 1u);
  EXPECT_EQ(projector_layer(scene.lights[2].projector, pictures), 0u);
  EXPECT_EQ(projector_layer(scene.lights[3].projector, pictures), 2u);
  EXPECT_EQ(projector_layer(scene.lights[4].projector, pictures), 3u);
}

TEST(Projectors, WidePicturesLieInTheMiddleOfTheirSquare) {
  scene::Scene scene;
  scene.images = {picture(4, 2, {kRed, kRed, kGreen, kGreen, kRed, kRed, kGreen, kGreen})};
  scene.lights = {thrower(0, 0.0f)};
  const scene::Image layer = only_layer(scene);
  EXPECT_EQ(layer.width, layer.height);
  EXPECT_EQ(texel(layer, 0.1f, 0.5f), kRed);
  EXPECT_EQ(texel(layer, 0.9f, 0.5f), kGreen);
  EXPECT_EQ(texel(layer, 0.1f, 0.26f), kRed);
  EXPECT_EQ(texel(layer, 0.1f, 0.24f), (Color{0, 0, 0, 255}));
  EXPECT_EQ(texel(layer, 0.9f, 0.76f), (Color{0, 0, 0, 255}));
}

// Half of the light, sRGB 188, in the middle of the edge.
TEST(Projectors, EdgesFade) {
  scene::Scene scene;
  scene.images = {picture(1, 1, {kWhite})};
  scene.lights = {thrower(0, 0.25f)};
  const scene::Image layer = only_layer(scene);
  EXPECT_EQ(texel(layer, 0.5f, 0.5f), kWhite);
  EXPECT_EQ(texel(layer, 0.13f, 0.5f), kWhite);
  EXPECT_NEAR(texel(layer, 0.0625f, 0.5f)[0], 188, 4);
  EXPECT_LT(texel(layer, 0.0f, 0.5f)[0], 10);
  EXPECT_LT(texel(layer, 0.5f, 0.999f)[1], 10);
}

TEST(Projectors, TransparentIsBlack) {
  scene::Scene scene;
  scene.images = {picture(1, 1, {kClear})};
  scene.lights = {thrower(0, 0.0f)};
  EXPECT_EQ(texel(only_layer(scene), 0.5f, 0.5f), (Color{0, 0, 0, 255}));
}

// Large ones are halved, which keeps their light.
TEST(Projectors, LargePicturesAreReduced) {
  scene::Scene scene;
  std::vector<Color> checks;
  for (int y = 0; y < 2048; ++y)
    for (int x = 0; x < 2048; ++x) checks.push_back((x + y) % 2 == 0 ? kWhite : Color{0, 0, 0, 255});
  scene.images = {picture(2048, 2048, checks)};
  scene.lights = {thrower(0, 0.0f)};
  const scene::Image layer = only_layer(scene);
  EXPECT_EQ(layer.width, 1024u);
  EXPECT_NEAR(texel(layer, 0.5f, 0.5f)[0], 188, 1);
}

}  // namespace
}  // namespace velarium::upload
