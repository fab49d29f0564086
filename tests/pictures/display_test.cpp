// From linear light to files: backgrounds, alpha, exposure, and what must come through unchanged.

#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/host.hpp"

namespace velarium::test {
namespace {

constexpr Tonemap kCurves[] = {Tonemap::neutral, Tonemap::agx, Tonemap::aces, Tonemap::linear};

glm::vec4 from_codes(const glm::vec3& codes) {
  return glm::vec4(shading::srgb_decode(codes / 255.0f), 1.0f);
}

// An unlit square of this colour, half as high as the picture, turned so that its edges cross pixels.
Scene tilted_square(const glm::vec4& color) {
  GltfWriter scene;
  const int material = scene.add_material({.base_color = color, .unlit = true});
  scene.add_quad(material, {0, 0, 0}, {0.3f, 0.2f, 1}, {1, 1});
  return scene.load();
}

// As wide as the picture, so that each pixel shows the colour.
Scene unlit_wall(const std::vector<glm::vec4>& stripes) {
  GltfWriter scene;
  const float width = 4.0f / static_cast<float>(stripes.size());
  for (std::size_t i = 0; i < stripes.size(); ++i) {
    const int material = scene.add_material({.base_color = stripes[i], .unlit = true});
    scene.add_quad(material, {-2.0f + width * (static_cast<float>(i) + 0.5f), 0, 0}, {0, 0, 1}, {width, 4});
  }
  return scene.load();
}

RenderRequest head_on(RenderRequest request) {
  request.look_at = LookAt{.eye = {0, 0, 1}, .vertical_fov_deg = 90.0f};
  return request;
}

TEST(Background, TransparentPicturesHaveStraightAlpha) {
  RenderRequest request = head_on(display_request(48, 48));
  request.settings.frame.spp = 16;
  request.background = Background::transparent;
  request.want_linear = true;
  const Picture picture = picture_of(tilted_square(from_codes({200, 120, 40})), request);
  int edges = 0, inside = 0, outside = 0;
  for (std::uint32_t y = 0; y < 48; ++y) {
    for (std::uint32_t x = 0; x < 48; ++x) {
      const Rgba8 pixel = byte_at(picture, x, y);
      if (pixel[3] == 0) {
        ++outside;
        EXPECT_EQ(linear_at(picture, x, y), glm::vec4(0.0f));
        continue;
      }
      ++(pixel[3] == 255 ? inside : edges);
      EXPECT_EQ((Rgba8{pixel[0], pixel[1], pixel[2], 255}), (Rgba8{200, 120, 40, 255})) << x << ", " << y;
      // Sixteen frames: alpha counts in sixteenths. Linear light is premultiplied by it.
      const glm::vec4 linear = linear_at(picture, x, y);
      EXPECT_EQ(linear.a * 16.0f, std::round(linear.a * 16.0f));
      EXPECT_NEAR(linear.r, linear.a * from_codes({200, 120, 40}).r, 1e-3f);
    }
  }
  EXPECT_GT(std::min({edges, inside, outside}), 30) << "the test must see all three";
}

TEST(Background, AColorIsExactlyThatColorUnderEveryCurve) {
  constexpr glm::vec3 kColors[] = {{0, 0, 0},    {255, 255, 255}, {1, 2, 3},
                                   {18, 52, 86}, {127, 128, 129}, {254, 200, 77}};
  const Scene scene = tilted_square(from_codes({200, 120, 40}));
  for (const Tonemap curve : kCurves) {
    for (const bool dither : {false, true}) {
      for (const glm::vec3& codes : kColors) {
        RenderRequest request = head_on(display_request(32, 32));
        request.background = Background::color;
        request.background_color = {codes.x / 255.0f, codes.y / 255.0f, codes.z / 255.0f};
        request.settings.display.tonemap = curve;
        request.settings.display.dither = dither;
        request.settings.display.exposure = 2.0f;  // of light, not of the background
        const Picture picture = picture_of(scene, request);
        const auto code = [](float c) { return static_cast<std::uint8_t>(c); };
        const Rgba8 expected{code(codes.x), code(codes.y), code(codes.z), 255};
        for (std::uint32_t x = 0; x < 32; ++x) ASSERT_EQ(byte_at(picture, x, 0), expected) << "curve " << int(curve);
        EXPECT_NE(byte_at(picture, 16, 16), expected);
      }
    }
  }
}

TEST(Background, WithoutEnvironmentIsBlackAndOpaque) {
  const Picture picture = picture_of(tilted_square(glm::vec4(1.0f)), head_on(linear_request(16, 16)));
  EXPECT_EQ(linear_at(picture, 0, 0), glm::vec4(0, 0, 0, 1));
}

TEST(Unlit, EveryCodeComesThroughTheLinearCurve) {
  std::vector<glm::vec4> stripes;
  stripes.reserve(256);
  for (int i = 0; i < 256; ++i) stripes.push_back(from_codes(glm::vec3(i, 255 - i, i / 2)));
  const Scene scene = unlit_wall(stripes);
  RenderRequest request = head_on(display_request(512, 256));  // the wall is twice as wide as high
  for (const bool dither : {false, true}) {
    request.settings.display.dither = dither;
    const Picture picture = picture_of(scene, request);
    for (int i = 0; i < 256; ++i) {
      const Rgba8 pixel = byte_at(picture, static_cast<std::uint32_t>(2 * i + 1), 128);
      const int expected[3] = {i, 255 - i, i / 2};
      // Dither may lift or lower by one what half floats keep within a part of a code.
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[static_cast<std::size_t>(c)], expected[c], dither ? 1 : 0) << i;
    }
  }
}

// Radiance before the sRGB encoding, from 16 bits: exposure and the linear curve alone lie between it and the scene.
float shown_radiance(const Picture& picture, std::uint32_t x) {
  return shading::srgb_decode_channel(picture.display.at(std::size_t{4} * x) / 65535.0f);
}

// Two greys side by side: 0.1 and 0.025.
Picture shown_greys(const Settings::display_settings& display) {
  RenderRequest request = head_on(display_request(32, 16));
  const auto kept = request.settings.display;
  request.settings.display = display;
  request.settings.display.tonemap = kept.tonemap;
  request.settings.output.bits = 16;
  return picture_of(unlit_wall({{0.1f, 0.1f, 0.1f, 1}, {0.025f, 0.025f, 0.025f, 1}}), request);
}

// Radiance is kept in half floats, display values in 16 bits.
constexpr float kRelativeError = 2e-3f;

void expect_shown(const Settings::display_settings& display, float factor) {
  const Picture picture = shown_greys(display);
  EXPECT_NEAR(shown_radiance(picture, 2), 0.1f * factor, 0.1f * factor * kRelativeError);
  EXPECT_NEAR(shown_radiance(picture, 30), 0.025f * factor, 0.025f * factor * kRelativeError);
}

TEST(Exposure, AStopDoubles) {
  for (const float stops : {0.0f, 1.0f, 3.0f, -2.0f}) expect_shown({.exposure = stops}, std::exp2(stops));
}

TEST(Exposure, Ev100DividesAsTheSaturationSpeedSays) {
  expect_shown({.exposure_mode = ExposureMode::ev100, .ev100 = 0.0f}, 1.0f / 1.2f);
  expect_shown({.exposure_mode = ExposureMode::ev100, .exposure = 1.0f, .ev100 = 3.0f}, 2.0f / (1.2f * 8.0f));
}

// The geometric mean of 0.1 and 0.025 is 0.05, which becomes 0.18.
TEST(Exposure, AutomaticPutsTheMeanLogLuminanceAtMiddleGrey) {
  expect_shown({.exposure_mode = ExposureMode::automatic}, 0.18f / 0.05f);
  expect_shown({.exposure_mode = ExposureMode::automatic, .exposure = 1.0f}, 0.36f / 0.05f);
}

TEST(Exposure, LinearLightIsBeforeIt) {
  RenderRequest request = head_on(linear_request(16, 16));
  const Scene scene = unlit_wall({{0.25f, 0.5f, 1.0f, 1.0f}});
  request.settings.display.exposure = 3.0f;
  EXPECT_EQ(linear_at(picture_of(scene, request), 8, 8), glm::vec4(0.25f, 0.5f, 1.0f, 1.0f));
}

TEST(Bits, EightAreTheSixteenRounded) {
  RenderRequest request = head_on(display_request(32, 16));
  request.settings.display.tonemap = Tonemap::neutral;
  request.environment = "studio";
  const Scene scene = tilted_square(from_codes({200, 120, 40}));
  const Picture eight = picture_of(scene, request);
  request.settings.output.bits = 16;
  const Picture sixteen = picture_of(scene, request);
  EXPECT_EQ(eight.display_bits, 8);
  EXPECT_EQ(sixteen.display_bits, 16);
  for (std::size_t i = 0; i < eight.display.size(); ++i) {
    EXPECT_EQ(eight.display[i] % 257, 0);
    EXPECT_NEAR(eight.display[i], sixteen.display[i], 129) << i;
  }
}

}  // namespace
}  // namespace velarium::test
