// Light through BLEND surfaces, of the sun, points and spots: as much as passes them (shading/translucency.glsl), on
// what lies behind them and on nothing else.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace velarium::test {
namespace {

constexpr std::uint32_t kSize = 96;
constexpr float kHalf = 1.5f;  // metres that pictures from above show each way

// (0.8, 0.2, 0.1) has the hue (1, 2/7, 1/6) beside kLeastHue, of which alpha 0.5 takes half: dyes (1, 9/14, 7/12).
const glm::vec4 kRed(0.8f, 0.2f, 0.1f, 0.5f);
const glm::vec3 kPastRed = 0.5f * glm::vec3(1.0f, 9.0f / 14.0f, 7.0f / 12.0f);
const glm::vec4 kGrey(0.5f, 0.5f, 0.5f, 0.25f);
const glm::vec3 kPastGrey(0.75f);
// Transmittances and pictures are kept in half floats, each rounded by up to 5e-4.
constexpr float kHalfFloats = 2e-3f;

int add_sheet_material(GltfWriter& scene, const glm::vec4& color) {
  return scene.add_material({.base_color = color, .double_sided = true, .alpha_mode = "BLEND"});
}

// A light at (2, 2, 0), or a sun from there, which throws what is at (1, 1, 0) to the origin.
struct LightCase {
  const char* name;
  const char* type;
  float size;  // radius, metres; of the sun its angle
};

constexpr LightCase kLights[] = {{"sun_sharp", "directional", 0.0f}, {"sun_soft", "directional", 0.03f},
                                 {"point_sharp", "point", 0.0f},     {"point_soft", "point", 0.08f},
                                 {"spot_sharp", "spot", 0.0f},       {"spot_soft", "spot", 0.08f}};

void PrintTo(const LightCase& light, std::ostream* out) {
  *out << light.name;
}

TestLight light_of(const LightCase& wanted) {
  const bool sun = std::string(wanted.type) == "directional";
  TestLight light{.type = wanted.type,
                  .intensity = sun ? 3.0f : 20.0f,
                  .inner_cone = 0.6f,
                  .outer_cone = 0.7f,
                  .position = {2, 2, 0},
                  .direction = {-1, -1, 0}};
  if (wanted.size > 0.0f) light.extras = {{sun ? "angular_radius" : "radius", wanted.size}};
  return light;
}

GltfWriter floor_under(const LightCase& light) {
  GltfWriter scene;
  scene.add_quad(scene.add_material({.base_color = {0.7f, 0.7f, 0.7f, 1.0f}}), {0, 0, 0}, {0, 1, 0}, {6, 6});
  scene.add_light(light_of(light));
  scene.add_orthographic_camera({0, 3, 0}, {0, 0, 0}, kHalf, 10.0f);
  return scene;
}

RenderRequest from_above(const std::string& options = "") {
  RenderRequest request = linear_request(kSize, kSize);
  set_options(request.settings, "sun_shadows.size=512 local_shadows.atlas=1024 " + options);
  return request;
}

constexpr const char* kOff = "sun_shadows.translucent=off local_shadows.translucent=off";

// Seen from above, rows go from +x to -x.
glm::vec3 on_floor(const Picture& picture, float x) {
  const auto row = static_cast<std::uint32_t>((kHalf - x) / (2.0f * kHalf) * kSize);
  return glm::vec3(linear_at(picture, kSize / 2, row));
}

// What translucency changes there.
glm::vec3 dye_at(const GltfWriter& scene, float x, const std::string& options = "") {
  const Scene loaded = scene.load();
  return on_floor(picture_of(loaded, from_above(options)), x) /
         on_floor(picture_of(loaded, from_above(options + " " + kOff)), x);
}

void expect_near(const glm::vec3& actual, const glm::vec3& expected, const std::string& where = "") {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], kHalfFloats) << where << " channel " << i;
}

class Translucency : public testing::TestWithParam<LightCase> {};

TEST_P(Translucency, TheFloorIsDyedInTheSheetsShadowAlone) {
  GltfWriter scene = floor_under(GetParam());
  scene.add_quad(add_sheet_material(scene, kRed), {1, 1, 0}, {0, 1, 0}, {0.6f, 0.6f});
  expect_near(dye_at(scene, 0.0f), kPastRed);
  expect_near(dye_at(scene, -1.3f), glm::vec3(1.0f));
}

TEST_P(Translucency, SheetsMultiply) {
  GltfWriter scene = floor_under(GetParam());
  scene.add_quad(add_sheet_material(scene, kGrey), {1, 1, 0}, {0, 1, 0}, {0.6f, 0.6f});
  scene.add_quad(add_sheet_material(scene, kRed), {1.1f, 1.1f, 0}, {0, 1, 0}, {0.6f, 0.6f});
  expect_near(dye_at(scene, 0.0f), kPastGrey * kPastRed);
}

// A sheet whose front looks away from the light, and which is not double-sided.
TEST_P(Translucency, BothSidesCount) {
  GltfWriter scene = floor_under(GetParam());
  scene.add_quad(scene.add_material({.base_color = kGrey, .alpha_mode = "BLEND"}), {1, 1, 0}, {0, -1, 0}, {0.6f, 0.6f});
  expect_near(dye_at(scene, 0.0f), kPastGrey);
}

// Of two sheets the upper one makes a veil, the lower one lies below the floor: it must not dye the floor.
TEST_P(Translucency, WhatOpaqueSurfacesHideDyesNothing) {
  GltfWriter scene = floor_under(GetParam());
  scene.add_quad(add_sheet_material(scene, kGrey), {1, 1, 0}, {0, 1, 0}, {0.6f, 0.6f});
  scene.add_quad(add_sheet_material(scene, kRed), {-0.1f, -0.1f, 0}, {0, 1, 0}, {2.0f, 2.0f});
  expect_near(dye_at(scene, 0.0f), kPastGrey);
}

// Of two sheets the upper one dyes the lower one, which dyes nothing that stands before it. The floor is black, so that
// sheets alone are seen.
TEST_P(Translucency, SheetsDyeSheetsBehindThemAlone) {
  GltfWriter scene = floor_under(GetParam());
  scene.add_quad(scene.add_material({.base_color = {0, 0, 0, 1}}), {0, 0.01f, 0}, {0, 1, 0}, {6, 6});
  scene.add_quad(add_sheet_material(scene, kGrey), {0.1f, 0.1f, 0}, {0, 1, 0}, {0.2f, 0.2f});
  scene.add_quad(add_sheet_material(scene, kRed), {1, 1, 0}, {0, 1, 0}, {0.6f, 0.6f});
  expect_near(dye_at(scene, 0.1f), kPastRed);
  expect_near(dye_at(scene, 1.0f), glm::vec3(1.0f));
}

TEST_P(Translucency, WhatStandsBeforeASheetIsNotDyed) {
  GltfWriter scene = floor_under(GetParam());
  scene.add_quad(scene.add_material({}), {0.3f, 0.3f, 0}, {0, 1, 0}, {0.4f, 0.4f});
  scene.add_quad(add_sheet_material(scene, kRed), {0.2f, 0.2f, 0}, {0, 1, 0}, {1.5f, 1.5f});
  for (const float x : {0.14f, 0.3f, 0.46f}) expect_near(dye_at(scene, x), glm::vec3(1.0f));
}

// Sheets of any tilt, in maps so coarse that a texel spans many pixels.
TEST_P(Translucency, NoSheetDyesItself) {
  for (const float tilt : {0.0f, 20.0f, 45.0f, 70.0f, 84.0f}) {
    GltfWriter scene;
    const float turn = glm::radians(45.0f + tilt);
    scene.add_quad(add_sheet_material(scene, kRed), {0, 0, 0}, {std::cos(turn), std::sin(turn), 0.3f}, {2, 2});
    scene.add_light(light_of(GetParam()));
    const Scene loaded = scene.load();
    const std::string coarse = "sun_shadows.size=128 local_shadows.largest=128";
    RenderRequest with = from_above(coarse), without = from_above(coarse + " " + kOff);
    for (RenderRequest* view : {&with, &without})
      view->look_at = LookAt{.eye = {2.5f, 3.0f, 2.0f}, .vertical_fov_deg = 45.0f};
    EXPECT_LT(largest_error(picture_of(loaded, with).linear, picture_of(loaded, without).linear), kHalfFloats) << tilt;
  }
}

INSTANTIATE_TEST_SUITE_P(Lights, Translucency, testing::ValuesIn(kLights),
                         [](const auto& row) { return std::string(row.param.name); });

std::vector<std::string> passes_of(const GltfWriter& scene, const std::string& options) {
  std::vector<std::string> names;
  for (const auto& pass : engine().render(scene.load(), from_above(options)).report.passes)
    if (pass.name.ends_with("_translucency")) names.push_back(pass.name);
  return names;
}

TEST(TranslucencyCosts, NothingWithoutSheets) {
  GltfWriter opaque = floor_under(kLights[0]);
  opaque.add_light(light_of(kLights[2]));
  opaque.add_box(opaque.add_material({}), {1, 1, 0}, {0.6f, 0.1f, 0.6f});
  EXPECT_TRUE(passes_of(opaque, "").empty());
  const auto bytes = [&](const GltfWriter& scene, const std::string& options) {
    return Engine(validated()).render(scene.load(), from_above(options)).report.device_bytes;
  };
  EXPECT_EQ(bytes(opaque, ""), bytes(opaque, kOff));

  GltfWriter sheet = floor_under(kLights[0]);
  sheet.add_light(light_of(kLights[2]));
  sheet.add_quad(add_sheet_material(sheet, kRed), {1, 1, 0}, {0, 1, 0}, {0.6f, 0.6f});
  EXPECT_EQ(passes_of(sheet, ""), (std::vector<std::string>{"local_translucency", "sun_translucency"}));
  EXPECT_TRUE(passes_of(sheet, kOff).empty());
  EXPECT_EQ(passes_of(sheet, "sun_shadows.translucent=off"), std::vector<std::string>{"local_translucency"});
  EXPECT_GT(bytes(sheet, ""), bytes(sheet, kOff));
}

// Two suns' worth of lights and two sheets.
Scene courtyard() {
  GltfWriter scene = floor_under(kLights[1]);
  for (const auto& light : {kLights[3], kLights[4]}) scene.add_light(light_of(light));
  scene.add_quad(add_sheet_material(scene, kRed), {1, 1, 0.3f}, {0.2f, 1, 0}, {0.6f, 0.9f});
  scene.add_quad(add_sheet_material(scene, kGrey), {0.6f, 0.8f, -0.3f}, {0, 1, 0.3f}, {0.9f, 0.6f});
  scene.add_box(scene.add_material({}), {0.8f, 1.2f, 0}, {0.2f, 0.2f, 0.2f});
  return scene.load();
}

TEST(Translucency, IsTheSameUnderFullBarriersAndForEveryWayToFindLamps) {
  const Scene scene = courtyard();
  const Picture once = picture_of(scene, from_above("frame.spp=2"));
  for (const char* other : {"frame.spp=2 frame.sync=paranoid", "frame.spp=2 lighting.path=all"})
    EXPECT_EQ(largest_error(picture_of(scene, from_above(other)).linear, once.linear), 0.0) << other;
}

// Maps that are kept keep what they knew of sheets, and are drawn anew where these come and go.
TEST(Translucency, KeptMapsKeepTheirVeils) {
  const Scene scene = courtyard();
  const std::string kept = "sun_shadows.update=staggered local_shadows.updates=32";
  Engine keeper(validated());
  const Picture first = keeper.picture(scene, from_above(kept));
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(largest_error(keeper.picture(scene, from_above(kept)).linear, first.linear), 0.0);
  const Picture off = keeper.picture(scene, from_above(kept + " " + kOff));
  EXPECT_GT(largest_error(off.linear, first.linear), 0.05);
  EXPECT_EQ(largest_error(keeper.picture(scene, from_above(kept)).linear, first.linear), 0.0);
}

}  // namespace
}  // namespace velarium::test
