// Lights at the edge of what makes sense, with all shadows on: no value that is not a number, no message of the
// validation layers, which fail the test by themselves, and light where there should be some.

#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace velarium::test {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
const glm::vec3 kEye(1.5f, 1.2f, 3.0f);

// A floor, a polished box that stands on it, a wall behind, and a pane of glass before.
Picture lit_by(const std::vector<TestLight>& lights) {
  GltfWriter scene;
  const int matt = scene.add_material({.base_color = {0.7f, 0.7f, 0.7f, 1}});
  const int metal = scene.add_material({.metallic = 1.0f, .perceptual_roughness = 0.0f, .specular = 1.0f});
  const int pane = scene.add_material({.base_color = {1, 1, 1, 0.3f}, .double_sided = true, .alpha_mode = "BLEND"});
  scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {8, 8});
  scene.add_quad(matt, {0, 2, -2}, {0, 0, 1}, {8, 4});
  scene.add_box(metal, {0, 0.5f, 0}, {1, 1, 1});
  scene.add_quad(pane, {0.5f, 0.6f, 1.2f}, {0, 0, 1}, {0.8f, 0.8f});
  for (const TestLight& light : lights) scene.add_light(light);
  RenderRequest request = linear_request(64, 48);
  request.settings.frame.spp = 2;
  request.look_at = LookAt{.eye = {kEye.x, kEye.y, kEye.z}, .target = {0, 0.5f, 0}};
  return picture_of(scene.load(), request);
}

// The share of the pixels that get light of any colour.
double lit_share(const Picture& picture) {
  std::size_t lit = 0;
  for (std::size_t i = 0; i < picture.linear.size(); i += 4)
    lit += std::max({picture.linear[i], picture.linear[i + 1], picture.linear[i + 2]}) > 0.0f ? 1 : 0;
  return static_cast<double>(lit) / (static_cast<double>(picture.linear.size()) / 4.0);
}

TestLight above(const char* type) {
  return {.type = type,
          .intensity = std::string(type) == "directional" ? 3.0f : 20.0f,
          .position = {1.0f, 2.0f, 1.0f},
          .direction = {-0.4f, -1.0f, -0.4f}};
}

constexpr const char* kTypes[] = {"directional", "point", "spot"};

TEST(DegenerateLights, NoIntensityIsNoLight) {
  for (const char* type : kTypes) {
    TestLight light = above(type);
    light.intensity = 0.0f;
    EXPECT_EQ(lit_share(lit_by({light})), 0.0) << type;
  }
}

TEST(DegenerateLights, TheLargestIntensityIsWhiteAndNotMore) {
  for (const char* type : kTypes)
    for (const float color : {1.0f, 1e30f}) {
      TestLight light = above(type);
      light.intensity = kLargest;
      light.color = glm::vec3(color, color, 1.0f);
      const Picture picture = lit_by({light, above("point")});
      EXPECT_TRUE(is_finite(picture)) << type << " of colour " << color;
      EXPECT_GT(lit_share(picture), 0.3) << type << " of colour " << color;
    }
}

TEST(DegenerateLights, BulbsOfNoAndOfAnySize) {
  const double of_a_point = lit_share(lit_by({above("point")}));
  for (const float radius : {0.0f, 1e-30f, 1.0f, 100.0f, kLargest}) {
    for (const char* falloff : {"inverse_square", "bulb"}) {
      TestLight light = above("point");
      light.extras = {{"radius", radius}, {"falloff", falloff}};
      const Picture picture = lit_by({light});
      EXPECT_TRUE(is_finite(picture)) << radius << " m, " << falloff;
      if (radius < 1e-6f) { EXPECT_NEAR(lit_share(picture), of_a_point, 0.02) << radius << " m, " << falloff; }
    }
  }
}

TEST(DegenerateLights, ConesFromAHairToAHalfSphere) {
  TestLight hair = above("spot"), half = hair, wide = hair;
  hair.outer_cone = 1e-6f;
  half.inner_cone = half.outer_cone - 1e-6f;
  wide.outer_cone = 0.5f * std::numbers::pi_v<float>;
  EXPECT_TRUE(is_finite(lit_by({hair})));
  EXPECT_LT(lit_share(lit_by({hair})), 0.01);
  EXPECT_TRUE(is_finite(lit_by({half})));
  const Picture picture = lit_by({wide});
  EXPECT_TRUE(is_finite(picture));
  EXPECT_GT(lit_share(picture), 0.3);
}

TEST(DegenerateLights, ConesThatAreNoneAreRefused) {
  TestLight none = above("spot"), beyond = none;
  none.outer_cone = 0.0f;
  beyond.outer_cone = std::numbers::pi_v<float>;
  for (const TestLight& light : {none, beyond}) EXPECT_THROW((void)lit_by({light}), Error) << light.outer_cone;
}

TEST(DegenerateLights, RangesOfNoAndOfAnyLength) {
  for (const char* type : {"point", "spot"})
    for (const float range : {1e-30f, 1e-3f, 1e18f, kLargest}) {
      TestLight light = above(type);
      light.range = range;
      const Picture picture = lit_by({light});
      EXPECT_TRUE(is_finite(picture)) << type << " of range " << range;
      EXPECT_EQ(lit_share(picture) > 0.2, range > 1.0f) << type << " of range " << range;
    }
}

TEST(DegenerateLights, InsideOfThingsOnThemAndAtTheEye) {
  const glm::vec3 inside(0, 0.5f, 0), on_floor(1, 0, 1), on_corner(0.5f, 1, 0.5f), in_pane(0.5f, 0.6f, 1.2f);
  for (const char* type : {"point", "spot"}) {
    for (const glm::vec3& place : {inside, on_floor, on_corner, in_pane, kEye}) {
      TestLight light = above(type);
      light.position = place;
      EXPECT_TRUE(is_finite(lit_by({light}))) << type << " at " << place.x << ", " << place.y << ", " << place.z;
    }
  }
  TestLight flash = above("point");
  flash.position = kEye;
  EXPECT_GT(lit_share(lit_by({flash})), 0.5);
}

// The floor gets nothing, or next to nothing; the wall that faces the sun is lit.
TEST(DegenerateLights, ASunOnTheHorizonAndAtTheZenith) {
  for (const float degrees : {0.0f, 1e-4f, 0.1f, -0.1f}) {
    const float elevation = glm::radians(degrees);
    TestLight sun = above("directional");
    sun.direction = {0, -std::sin(elevation), -std::cos(elevation)};
    const Picture picture = lit_by({sun});
    EXPECT_TRUE(is_finite(picture)) << degrees << " degrees";
    EXPECT_GT(linear_at(picture, 60, 6).x, 0.3f) << "the wall, " << degrees << " degrees";
    EXPECT_LT(linear_at(picture, 60, 45).x, 0.01f) << "the floor, " << degrees << " degrees";
  }
  TestLight noon = above("directional");
  noon.direction = {0, -1, 0};
  const Picture picture = lit_by({noon});
  EXPECT_TRUE(is_finite(picture));
  EXPECT_GT(linear_at(picture, 60, 45).x, 0.3f);
}

TEST(DegenerateLights, TenThousandOfThem) {
  std::vector<TestLight> lights;
  for (int i = 0; i < 10000; ++i) {
    const float turn = 2.399963f * static_cast<float>(i), far = 0.04f * std::sqrt(static_cast<float>(i));
    TestLight light = above(i % 4 == 0 ? "spot" : "point");
    light.intensity = 0.02f;
    light.range = 0.8f;
    light.position = {far * std::cos(turn), 0.1f + 0.0002f * static_cast<float>(i), far * std::sin(turn)};
    lights.push_back(light);
  }
  const Picture picture = lit_by(lights);
  EXPECT_TRUE(is_finite(picture));
  EXPECT_GT(lit_share(picture), 0.5);
}

}  // namespace
}  // namespace velarium::test
