// Where the sun of a request stands, and how bright it is: radiance of a Lambert plane is E n.l / pi.

#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace velarium::test {
namespace {

// Normals, whose codes have 8 bits, are 0.3 degrees off at the most.
constexpr float kTolerance = 0.006f;

// What the middle of a white plane of this normal shows, seen head-on.
float radiance_of(const glm::vec3& normal, const Sun& sun, const std::optional<TestLight>& light = {}) {
  GltfWriter scene;
  scene.add_quad(scene.add_material({}), glm::vec3(0.0f), normal, glm::vec2(20.0f));
  if (light) scene.add_light(*light);
  RenderRequest request = linear_request(9, 9);
  const glm::vec3 eye = 2.0f * normal, up = std::abs(normal.y) > 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  request.look_at = LookAt{.eye = {eye.x, eye.y, eye.z}, .up = {up.x, up.y, up.z}};
  request.sun = sun;
  request.settings.lighting.punctual = false;
  return linear_at(picture_of(scene.load(), request), 4, 4).g;
}

Sun sun_at(float azimuth_deg, float elevation_deg) {
  return {.azimuth_deg = azimuth_deg, .elevation_deg = elevation_deg, .illuminance_lux = glm::pi<float>()};
}

TEST(Sun, AzimuthGrowsFromZToX) {
  EXPECT_NEAR(radiance_of({0, 0, 1}, sun_at(0.0f, 0.0f)), 1.0f, kTolerance);
  EXPECT_NEAR(radiance_of({1, 0, 0}, sun_at(90.0f, 0.0f)), 1.0f, kTolerance);
  EXPECT_NEAR(radiance_of({0, 0, -1}, sun_at(180.0f, 0.0f)), 1.0f, kTolerance);
  EXPECT_NEAR(radiance_of({-1, 0, 0}, sun_at(270.0f, 0.0f)), 1.0f, kTolerance);
  EXPECT_NEAR(radiance_of({1, 0, 0}, sun_at(30.0f, 0.0f)), 0.5f, kTolerance);
  EXPECT_EQ(radiance_of({1, 0, 0}, sun_at(200.0f, 0.0f)), 0.0f);
}

TEST(Sun, ElevationIsAboveTheHorizon) {
  EXPECT_NEAR(radiance_of({0, 1, 0}, sun_at(123.0f, 90.0f)), 1.0f, kTolerance);
  EXPECT_NEAR(radiance_of({0, 1, 0}, sun_at(123.0f, 30.0f)), 0.5f, kTolerance);
  EXPECT_EQ(radiance_of({0, 1, 0}, sun_at(123.0f, -5.0f)), 0.0f);
}

// Half of a small disc above the horizon: two thirds of its sine, over pi. The plane's normal in 8 bits counts by half.
TEST(Sun, SetsAsADisc) {
  Sun wide = sun_at(0.0f, 0.0f);
  wide.angular_radius_deg = 10.0f;
  const float half_disc = 2.0f / 3.0f * std::sin(glm::radians(10.0f)) * glm::one_over_pi<float>();
  EXPECT_NEAR(radiance_of({0, 1, 0}, wide), half_disc, 0.5f * kTolerance);
}

TEST(Sun, ShinesInsteadOfTheScenesOwnLights) {
  const TestLight light{.type = "directional", .intensity = 100.0f, .direction = {0, -1, 0}};
  EXPECT_NEAR(radiance_of({0, 1, 0}, sun_at(0.0f, 90.0f), light), 1.0f, kTolerance);
}

}  // namespace
}  // namespace velarium::test
