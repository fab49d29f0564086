// Lights, and what their extras say beyond glTF. The schema in docs is held to the reader: what it allows is read
// without a warning, what it forbids is warned of and ignored.

#include "gltf_model.hpp"
#include "scene/snapshot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace velarium::scene::test {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// A grey picture of 2 x 1 pixels.
constexpr const char* kPicture =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR42mNoaGj4D8IAFQME///4h5sAAAAASUVORK5CYII=";

Json schema() {
  std::ifstream file(VELARIUM_DOCS "/light_extras.schema.json");
  return Json::parse(file);
}

// A triangle and a light of this kind with these extras, which may name the file's only picture.
Model lit_by(const std::string& kind, const Json& extras) {
  Model model = triangle();
  Json light{{"type", kind}, {"intensity", 5.0f}, {"extras", extras}};
  if (kind == "spot") light["spot"] = {{"outerConeAngle", 0.5f}};
  model.root["extensionsUsed"] = {"KHR_lights_punctual"};
  model.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
  model.root["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  model.root["images"] = Json::array({{{"uri", kPicture}}});
  model.root["nodes"].push_back({{"extras", {{"clip_volume", {{"name", "hall"}, {"half_size", {1, 1, 1}}}}}}});
  return model;
}

// The kind of light that a member is for.
std::string kind_for(const std::string& member) {
  if (member == "angular_radius") return "directional";
  return member == "projector" ? "spot" : "point";
}

// Values that stand for the file's picture in examples of the schema.
Json with_picture(Json extras) {
  if (extras.contains("projector") && extras["projector"].is_object() && extras["projector"].contains("image") &&
      extras["projector"]["image"].is_string())
    extras["projector"]["image"] = kPicture;
  return extras;
}

// What a member needs beside it to have a meaning.
Json beside(const std::string& member, const Json& value) {
  Json extras = Json::object();
  if (member == "cutoff" || value == "bulb") extras = {{"radius", 0.1f}, {"falloff", "bulb"}};
  extras[member] = value;
  return with_picture(extras);
}

Scene scene_with(const std::string& member, const Json& value) {
  return read(lit_by(kind_for(member), beside(member, value)));
}

Json projector_with(const std::string& member, const Json& value) {
  Json projector{{"image", 0}};
  projector[member] = value;
  return projector;
}

// Numbers that the schema says are out of range.
std::vector<Json> forbidden_numbers(const Json& rule) {
  std::vector<Json> numbers;
  if (rule.contains("exclusiveMinimum")) numbers.push_back(rule["exclusiveMinimum"]);
  if (rule.contains("exclusiveMaximum")) numbers.push_back(rule["exclusiveMaximum"].get<double>() + 1e-5);
  if (rule.contains("minimum")) numbers.push_back(rule["minimum"].get<double>() - 1.0);
  if (rule.contains("maximum")) numbers.push_back(rule["maximum"].get<double>() + 1e-5);
  return numbers;
}

TEST(LightExtrasSchema, ExamplesAreReadWithoutWarning) {
  const Json root = schema();
  for (const auto& [member, rule] : root["properties"].items())
    for (const Json& example : rule.at("examples"))
      EXPECT_TRUE(scene_with(member, example).warnings.empty()) << member << " " << example;
  for (const auto& [member, rule] : root["properties"]["projector"]["properties"].items())
    for (const Json& example : rule.at("examples"))
      EXPECT_TRUE(scene_with("projector", projector_with(member, example)).warnings.empty())
          << member << " " << example;
  for (const Json& example : root["examples"])
    EXPECT_TRUE(read(lit_by("spot", with_picture(example))).warnings.empty()) << example;
}

TEST(LightExtrasSchema, WhatItForbidsIsWarnedOf) {
  const Json root = schema();
  for (const auto& [member, rule] : root["properties"].items()) {
    std::vector<Json> wrong = forbidden_numbers(rule);
    wrong.push_back(Json::array());
    for (const Json& value : wrong)
      EXPECT_TRUE(has_warning(scene_with(member, value), "ignored")) << member << " " << value;
  }
  for (const auto& [member, rule] : root["properties"]["projector"]["properties"].items()) {
    std::vector<Json> wrong = forbidden_numbers(rule);
    wrong.push_back(Json::array());
    for (const Json& value : wrong)
      EXPECT_TRUE(has_warning(scene_with("projector", projector_with(member, value)), "ignored"))
          << member << " " << value;
  }
  EXPECT_TRUE(has_warning(scene_with("projector", Json::object()), "ignored"));
}

TEST(LightExtrasSchema, DefaultsAreThoseOfTheScene) {
  const Json root = schema();
  const Light light;
  EXPECT_EQ(root["properties"]["casts_shadow"]["default"], light.casts_shadow);
  EXPECT_EQ(root["properties"]["falloff"]["default"], "inverse_square");
  EXPECT_EQ(light.falloff, Falloff::inverse_square);
  EXPECT_FLOAT_EQ(root["properties"]["projector"]["properties"]["soft_edge"]["default"].get<float>(),
                  light.projector.soft_edge);
}

Light first_light(const Model& model) {
  return read(model).lights.at(0);
}

// Lights that take light away are not what glTF means: what is below 0 counts as 0, and a warning says so.
TEST(Lights, AreNeverNegative) {
  Model model = lit_by("point", Json::object());
  Json& light = model.root["extensions"]["KHR_lights_punctual"]["lights"][0];
  light["color"] = {-1.0f, 0.5f, 2.0f};
  EXPECT_EQ(first_light(model).color, glm::vec3(0.0f, 0.5f, 2.0f));
  light["intensity"] = -3.0f;
  EXPECT_EQ(first_light(model).intensity, 0.0f);
  EXPECT_TRUE(has_warning(read(model), "outside its range"));
}

// JSON knows no NaN; what exceeds a 32-bit float is refused in what glTF defines, and means nothing in extras.
TEST(Lights, AreNumbersOrRefused) {
  Model model = lit_by("point", {{"radius", 1e300}, {"cutoff", 1e300}, {"falloff", "bulb"}});
  EXPECT_EQ(first_light(model).radius, 0.0f);
  EXPECT_EQ(first_light(model).falloff, Falloff::inverse_square);
  Json& light = model.root["extensions"]["KHR_lights_punctual"]["lights"][0];
  light["intensity"] = 1e300;
  expect_refused(model, "/extensions/KHR_lights_punctual/lights/0/intensity");
  light["intensity"] = 1.0f;
  light["color"] = {1.0f, 1e300, 1.0f};
  expect_refused(model, "/extensions/KHR_lights_punctual/lights/0/color/1");
  for (const double none : {-0.5, 1e300})
    EXPECT_EQ(first_light(lit_by("directional", {{"angular_radius", none}})).angular_radius, 0.0f) << none;
}

TEST(LightExtras, MakeABulb) {
  const Scene scene =
      read(lit_by("point", {{"radius", 0.25f}, {"falloff", "bulb"}, {"cutoff", 8}, {"casts_shadow", false}}));
  const Light& light = scene.lights.at(0);
  EXPECT_EQ(light.radius, 0.25f);
  EXPECT_EQ(light.falloff, Falloff::bulb);
  EXPECT_EQ(light.range, 8.0f);
  EXPECT_FALSE(light.casts_shadow);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(LightExtras, BulbsNeedARadius) {
  const Scene scene = read(lit_by("point", {{"falloff", "bulb"}}));
  EXPECT_EQ(scene.lights.at(0).falloff, Falloff::inverse_square);
  EXPECT_TRUE(has_warning(scene, "/extensions/KHR_lights_punctual/lights/0/extras/falloff: needs a radius"));
}

TEST(LightExtras, GiveTheSunADisc) {
  EXPECT_EQ(read(lit_by("directional", {{"angular_radius", 0.00465f}})).lights.at(0).angular_radius, 0.00465f);
}

TEST(LightExtras, OfOtherApplicationsMeanNothing) {
  for (const Json& extras : {Json("a note"), Json(3), Json::array({1, 2}), Json{{"name", "lamp 7"}}, Json(nullptr)}) {
    const Scene scene = read(lit_by("spot", extras));
    EXPECT_TRUE(scene.warnings.empty()) << extras;
    EXPECT_EQ(scene.lights.at(0).radius, 0.0f);
  }
}

TEST(Projectors, ThrowAPictureOfTheFile) {
  for (const Json& image : {Json(0), Json(kPicture)}) {
    const Scene scene = read(lit_by("spot", {{"projector", {{"image", image}}}}));
    const Projector& projector = scene.lights.at(0).projector;
    ASSERT_EQ(projector.image, 0);
    EXPECT_FLOAT_EQ(projector.field_of_view, 1.0f);  // twice the outer cone angle
    ASSERT_EQ(scene.images.size(), 1u);              // though no material uses it
    EXPECT_EQ(scene.images[0].width, 2u);
  }
}

TEST(Projectors, BelongToSpots) {
  const Scene scene = read(lit_by("point", {{"projector", {{"image", 0}}}}));
  EXPECT_FALSE(scene.lights.at(0).projector.present());
  EXPECT_TRUE(has_warning(scene, "belongs to a light that is no spot"));
  EXPECT_TRUE(scene.images.empty());
}

// A projector's picture stands upright as its node does: right is the node's +X, also where the node is squeezed.
TEST(Projectors, StandAsTheirNodesDo) {
  Model model = lit_by("spot", {{"projector", {{"image", 0}}}});
  model.root["nodes"][0]["rotation"] = {0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)};  // +X to +Y
  model.root["nodes"][0]["scale"] = {2.0, 0.5, 3.0};
  const LightInstance light = snapshot_at(read(model), 0.0f, "").lights.at(0);
  EXPECT_LT(glm::length(light.right - glm::vec3(0, 1, 0)), 1e-6f);
  EXPECT_LT(glm::length(light.direction - glm::vec3(0, 0, -1)), 1e-6f);
}

}  // namespace
}  // namespace velarium::scene::test
