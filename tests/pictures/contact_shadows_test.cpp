// Contact shadows: as long as they are, and none where nothing stands.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace velarium::test {
namespace {

constexpr std::uint32_t kSide = 80;  // pixels
constexpr float kPixel = 0.001f;     // metres at the floor
constexpr float kStep = 0.01f;       // metres, high and wide
constexpr float kEyeHeight = 0.5f;   // metres

// Lights have no maps, rays are long and fine: what the march alone finds.
RenderRequest alone(RenderRequest request) {
  set_options(request.settings,
              "local_shadows.enabled=off contact_shadows.enabled=on contact_shadows.without_map=on "
              "contact_shadows.length=0.5 contact_shadows.thickness=0.5 contact_shadows.steps=64");
  return request;
}

RenderRequest without(RenderRequest request) {
  request.settings.contact_shadows.enabled = false;
  return request;
}

// A step down along x = 0 from y = 0.01 to the floor, which lights throw a shadow from that is as wide as it is high.
// The sun, which has a map, is another light, from below, where it lights nothing that is seen.
Scene step(const std::vector<TestLight>& lights) {
  GltfWriter scene;
  const int matt = scene.add_material({});
  scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {1, 1});
  scene.add_box(matt, {-0.1f, 0.5f * kStep, 0}, {0.2f, kStep, 0.4f});
  for (const auto& light : lights) scene.add_light(light);
  scene.add_light({.type = "directional", .intensity = 9.0f, .direction = {0, 1, 0}});
  scene.add_orthographic_camera({0, kEyeHeight, 0}, {0, 0, 0}, 0.5f * kPixel * kSide, 2.0f);
  return scene.load();
}

RenderRequest perspective_from_above() {
  RenderRequest request = linear_request(kSide, kSide);
  const float fov = 2.0f * std::atan(0.5f * kPixel * kSide / kEyeHeight);
  request.look_at =
      LookAt{.eye = {0, kEyeHeight, 0}, .target = {0, 0, 0}, .up = {1, 0, 0}, .vertical_fov_deg = glm::degrees(fov)};
  return request;
}

// How many pixels of the middle column lose light to the march.
int shadow_pixels(const Scene& scene, const RenderRequest& request) {
  const Picture with = picture_of(scene, alone(request)), open = picture_of(scene, without(alone(request)));
  int dark = 0;
  for (std::uint32_t y = 0; y < kSide; ++y)
    dark += linear_at(with, kSide / 2, y).x < 0.5f * linear_at(open, kSide / 2, y).x ? 1 : 0;
  return dark;
}

TEST(ContactShadows, AStepThrowsAShadowOfItsHeightUnder45Degrees) {
  const TestLight sun{.type = "directional", .direction = {1, -1, 0}};
  const int expected = static_cast<int>(kStep / kPixel);
  EXPECT_NEAR(shadow_pixels(step({sun}), linear_request(kSide, kSide)), expected, 1);
  EXPECT_NEAR(shadow_pixels(step({sun}), perspective_from_above()), expected, 1);
}

TEST(ContactShadows, ComeFromLampsAsWell) {
  // Two centimetres high and so far beyond the edge that rays over it come down at 45 degrees.
  const TestLight light{.intensity = 0.01f, .position = {-0.01f, 2.0f * kStep, 0}};
  EXPECT_NEAR(shadow_pixels(step({light}), linear_request(kSide, kSide)), static_cast<int>(kStep / kPixel), 1);
}

TEST(ContactShadows, NothingBeyondALampBlocksIt) {
  GltfWriter scene;
  const int matt = scene.add_material({});
  scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {1, 1});
  scene.add_box(matt, {-0.03f, 0.05f, 0}, {0.02f, 0.1f, 0.4f});
  scene.add_light({.intensity = 0.01f, .position = {-0.01f, 0.005f, 0}});
  scene.add_orthographic_camera({0, kEyeHeight, 0}, {0, 0, 0}, 0.5f * kPixel * kSide, 2.0f);
  EXPECT_EQ(shadow_pixels(scene.load(), linear_request(kSide, kSide)), 0);
}

TEST(ContactShadows, ComeFromLightsThatCastShadows) {
  const TestLight sun{.type = "directional", .direction = {1, -1, 0}, .extras = {{"casts_shadow", false}}};
  EXPECT_EQ(shadow_pixels(step({sun}), linear_request(kSide, kSide)), 0);
}

TEST(ContactShadows, LampsWithoutMapsThrowThemOnlyWhereAsked) {
  const TestLight light{.intensity = 0.01f, .position = {-0.01f, 2.0f * kStep, 0}};
  const Scene scene = step({light});
  RenderRequest request = alone(linear_request(kSide, kSide));
  const Picture open = picture_of(scene, without(request));
  request.settings.contact_shadows.without_map = false;
  EXPECT_EQ(largest_error(picture_of(scene, request).linear, open.linear), 0.0);
}

// Light from above, which throws no shadow, is a 20th of the light's where that shines from 45 degrees, or 40 times as
// much.
TEST(ContactShadows, OnlyALampThatGivesMoreThanHalfOfTheLightThrowsOne) {
  const TestLight light{.intensity = 0.01f, .position = {-0.01f, 2.0f * kStep, 0}};
  TestLight above{
      .type = "directional", .intensity = 1.0f, .direction = {0, -1, 0}, .extras = {{"casts_shadow", false}}};
  EXPECT_NEAR(shadow_pixels(step({light, above}), linear_request(kSide, kSide)), static_cast<int>(kStep / kPixel), 1);
  above.intensity = 1000.0f;
  const Scene scene = step({light, above});
  const RenderRequest request = alone(linear_request(kSide, kSide));
  EXPECT_EQ(largest_error(picture_of(scene, request).linear, picture_of(scene, without(request)).linear), 0.0);
}

// How many pixels of the middle column the sun's mask hides.
int hidden_pixels(const Scene& scene, const char* options) {
  RenderRequest request = linear_request(kSide, kSide);
  set_options(request.settings, options);
  request.dumps = {"sun_shadow_mask.occlusion"};
  const auto mask = engine().render(scene, request).dumps.front();
  int hidden = 0;
  for (std::size_t y = 0; y < kSide; ++y) hidden += mask.rgba[4 * (kSide * y + kSide / 2)] > 0.5f ? 1 : 0;
  return hidden;
}

// A map of 64 texels over the floor's metre has no step of a centimetre; one of 2048 texels has.
TEST(ContactShadows, OfTheSunStandInItsMaskWhereTheMapIsTooCoarse) {
  GltfWriter writer;
  const int matt = writer.add_material({});
  writer.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {1, 1});
  writer.add_box(matt, {-0.1f, 0.5f * kStep, 0}, {0.2f, kStep, 0.4f});
  writer.add_light({.type = "directional", .direction = {1, -1, 0}});
  writer.add_orthographic_camera({0, kEyeHeight, 0}, {0, 0, 0}, 0.5f * kPixel * kSide, 2.0f);
  const Scene scene = writer.load();
  constexpr const char* kCoarse =
      "sun_shadows.size=64 sun_shadows.cascades=1 contact_shadows.length=0.5 "
      "contact_shadows.thickness=0.5 contact_shadows.steps=64 contact_shadows.enabled=";
  const int expected = static_cast<int>(kStep / kPixel);
  EXPECT_LT(hidden_pixels(scene, (std::string(kCoarse) + "off").c_str()), expected / 2);
  EXPECT_NEAR(hidden_pixels(scene, (std::string(kCoarse) + "on").c_str()), expected, 1);
  EXPECT_NEAR(hidden_pixels(scene, ""), expected, 1);
}

// At any angle of light and view, with the noise of several frames.
TEST(ContactShadows, APlaneThrowsNoneOnItself) {
  const auto plane = [](float elevation_deg, float turn) {
    GltfWriter scene;
    scene.add_quad(scene.add_material({}), {0, 0, 0}, {0, 1, 0}, {60, 60});
    const float e = glm::radians(elevation_deg);
    scene.add_light({.type = "directional",
                     .intensity = 3.0f,
                     .direction = {-std::cos(e) * std::cos(turn), -std::sin(e), -std::cos(e) * std::sin(turn)}});
    return scene.load();
  };
  for (const float light_deg : {1.0f, 8.0f, 45.0f, 89.0f})
    for (const float turn : {0.0f, 1.1f, 3.1f}) {
      const Scene scene = plane(light_deg, turn);
      for (const float view_deg : {2.0f, 10.0f, 60.0f}) {
        SCOPED_TRACE(testing::Message() << "light " << light_deg << ", view " << view_deg << ", turn " << turn);
        RenderRequest request = linear_request(61, 47);
        request.settings.frame.spp = 2;
        const float v = glm::radians(view_deg);
        request.look_at = LookAt{.eye = {0.3f, 4.0f * std::sin(v), 4.0f * std::cos(v)}};
        EXPECT_EQ(
            largest_error(picture_of(scene, alone(request)).linear, picture_of(scene, without(alone(request))).linear),
            0.0);
      }
    }
}

}  // namespace
}  // namespace velarium::test
