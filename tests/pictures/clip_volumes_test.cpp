// Lights that end at a volume: two rooms that share a wall, the walls in the planes of the volume itself.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <velarium/reference.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::test {
namespace {

// Everything in room A is red, everything in room B is green: what a light of A does in B is in the green channel.
class Rooms {
 public:
  explicit Rooms(const TestLight& light, const glm::dvec3& origin = glm::dvec3(0.0)) : scene_(origin) {
    const int red = scene_.add_material({.base_color = {1, 0, 0, 1}}),
              green = scene_.add_material({.base_color = {0, 1, 0, 1}});
    add_room(red, -1.0f);
    add_room(green, 1.0f);
    const int glass = scene_.add_material({.base_color = {0, 1, 0, 0.5f}, .double_sided = true, .alpha_mode = "BLEND"});
    scene_.add_quad(glass, {2.0f, 1.5f, 0.0f}, {1, 0, 1}, {1, 1});
    scene_.add_clip_box("A", {-2.0f, 1.5f, 0.0f}, {2.0f, 1.5f, 3.0f});
    scene_.add_light(light);
    scene_.add_orthographic_camera({5, 8, 9}, {0, 0, 0}, 5.0f, 40.0f);
  }

  [[nodiscard]] Scene load() const { return scene_.load(); }

 private:
  // side: -1 for x from -4 to 0, +1 for x from 0 to 4. The wall between leaves a doorway; there is no ceiling.
  void add_room(int material, float side) {
    scene_.add_quad(material, {2.0f * side, 0, 0}, {0, 1, 0}, {6, 4});
    scene_.add_quad(material, {2.0f * side, 1.5f, -3}, {0, 0, 1}, {4, 3});
    scene_.add_quad(material, {4.0f * side, 1.5f, 0}, {-side, 0, 0}, {6, 3});
    scene_.add_quad(material, {0, 1.5f, -1}, {side, 0, 0}, {4, 3});
  }

  GltfWriter scene_;
};

TestLight test_light(const char* type) {
  const bool directional = std::string(type) == "directional";
  return {.type = type,
          .intensity = directional ? 2.0f : 10.0f,
          .outer_cone = 1.3f,
          .position = {-1.0f, 1.5f, 0.5f},
          .direction = {0.6f, -0.5f, 0.2f},
          .extras = {{"casts_shadow", false}}};
}

TestLight ended(TestLight light) {
  light.extras["clip_volume"] = "A";
  return light;
}

float largest(const Picture& picture, std::size_t channel) {
  float most = 0.0f;
  for (std::size_t i = channel; i < picture.linear.size(); i += 4) most = std::max(most, picture.linear[i]);
  return most;
}

RenderRequest seen_from(const glm::vec3& eye, const glm::vec3& target) {
  RenderRequest request = linear_request(97, 73);
  request.look_at =
      LookAt{.eye = {eye.x, eye.y, eye.z}, .target = {target.x, target.y, target.z}, .vertical_fov_deg = 70.0f};
  return request;
}

// Vulkan lets vertices snap to 1/16 of a pixel. Where they do, a surface that ends in a plane of the volume is seen up
// to half of that beyond: of the pixels along such edges, one in a few tens lies on the wrong side.
constexpr double kOnTheWrongSide = 0.001;  // of all pixels

// Nothing reaches B, and A is as it is without a volume, to the bit.
void expect_only_room_a(const TestLight& light, const RenderRequest& request, const glm::dvec3& origin = {}) {
  const auto without = engine().render(Rooms(light, origin).load(), request);
  const Picture& open = without.picture;
  ASSERT_GT(largest(open, 0), 0.05f);
  ASSERT_GT(largest(open, 1), 0.05f) << "without a volume the light reaches room B";
  const Picture closed = picture_of(Rooms(ended(light), origin).load(), request);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < open.linear.size(); i += 4)
    wrong += closed.linear[i] != open.linear[i] || closed.linear[i + 1] != 0.0f ? 1u : 0u;
  const bool snaps_finely = without.report.device.starts_with("llvmpipe");  // to 1/256
  const double allowed = snaps_finely ? 0.0 : kOnTheWrongSide * open.width * open.height;
  EXPECT_LE(static_cast<double>(wrong), allowed);
}

TEST(ClipVolumes, EndEachKindOfLight) {
  for (const char* type : {"directional", "point", "spot"}) {
    SCOPED_TRACE(type);
    expect_only_room_a(test_light(type), seen_from({-3.5f, 1.6f, 2.7f}, {0.5f, 0.9f, 0.5f}));
  }
}

TEST(ClipVolumes, DoNotDependOnWhereTheEyeIs) {
  const glm::vec3 inside(-3.5f, 1.6f, 2.7f), beside(3.5f, 2.0f, 2.9f), above(1.0f, 6.0f, 5.0f);
  for (const glm::vec3& eye : {inside, beside, above})
    expect_only_room_a(test_light("point"), seen_from(eye, {0, 0.5f, 0}));
  expect_only_room_a(test_light("point"), linear_request(97, 73));  // the orthographic camera
}

TEST(ClipVolumes, HoldFarFromTheOrigin) {
  const glm::vec3 origin(102400.0f, 0.0f, -102400.0f);
  // Past the threshold: a pixel that looked straight at it would lie in both rooms.
  const glm::vec3 eye(-3.5f, 1.625f, 2.75f), target(0.5f, 0.875f, 0.5f);
  expect_only_room_a(test_light("point"), seen_from(origin + eye, origin + target), origin);
}

TEST(ClipVolumes, TilesLoseNothing) {
  const Scene scene = Rooms(ended(test_light("point"))).load();
  RenderRequest request = seen_from({1.0f, 6.0f, 5.0f}, {0, 0.5f, 0});
  const Picture tiled = picture_of(scene, request);
  request.settings.lighting.path = LightingPath::all;
  EXPECT_EQ(largest_error(tiled.linear, picture_of(scene, request).linear), 0.0);
}

TEST(ClipVolumes, EndLightsThatAreDrawnAsBodies) {
  RenderRequest request = seen_from({-3.5f, 1.6f, 2.7f}, {0.5f, 0.9f, 0.5f});
  request.settings.lighting.path = LightingPath::volumes;
  expect_only_room_a(test_light("spot"), request);
}

TEST(ClipVolumes, EndLightsOfThePathTracerToo) {
  ReferenceRequest request{.view = seen_from({-3.5f, 1.6f, 2.7f}, {0.5f, 0.9f, 0.5f})};
  request.view.settings.reference.spp = 4;
  request.view.settings.reference.transport = Transport::direct;
  TestLight ball = test_light("point");
  ball.extras["radius"] = 0.2f;
  for (const TestLight& light : {test_light("spot"), ball}) {
    const Picture open = render_reference(Rooms(light).load(), request).picture;
    EXPECT_GT(largest(open, 1), 0.05f);
    const Picture closed = render_reference(Rooms(ended(light)).load(), request).picture;
    EXPECT_EQ(largest(closed, 1), 0.0f);
    EXPECT_GT(largest(closed, 0), 0.05f);
  }
}

}  // namespace
}  // namespace velarium::test
