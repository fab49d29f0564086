// Points and lines.

#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace velarium::test {
namespace {

// One at the origin, under a bright sun: an accessor without a view is all zeros.
constexpr const char* kPoint = R"({
  "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_unlit"],
  "accessors": [{"componentType": 5126, "type": "VEC3", "count": 1, "min": [0, 0, 0], "max": [0, 0, 0]}],
  "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0, 1]}, "emissiveFactor": [0, 0, 0.5]MORE}],
  "meshes": [{"primitives": [{"mode": 0, "attributes": {"POSITION": 0}, "material": 0}]}],
  "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 100}]}},
  "cameras": [{"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 10}}],
  "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 5]}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
  "scenes": [{"nodes": [0, 1, 2]}]})";

glm::vec4 middle_of_point(const std::string& more) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "point.gltf";
  std::string text = kPoint;
  text.replace(text.find("MORE"), 4, more);
  std::ofstream(file) << text;
  return linear_at(picture_of(Scene::load(file), linear_request(9, 9)), 4, 4);
}

// glTF 2.0, 3.9.7: the sum of base colour and emission, whatever lights there are.
TEST(Points, WithoutNormalsShowWhatTheyAreAndGive) {
  EXPECT_EQ(middle_of_point(""), glm::vec4(0.25f, 0.5f, 0.5f, 1.0f));
  EXPECT_EQ(middle_of_point(R"(, "alphaMode": "BLEND")"), glm::vec4(0.25f, 0.5f, 0.5f, 1.0f));
}

TEST(Points, OfUnlitMaterialsShowTheirColourAlone) {
  EXPECT_EQ(middle_of_point(R"(, "extensions": {"KHR_materials_unlit": {}})"), glm::vec4(0.25f, 0.5f, 0.0f, 1.0f));
}

}  // namespace
}  // namespace velarium::test
