// A Lambert surface under lights of KHR_lights_punctual: radiance = albedo E / pi, at every pixel.
//
// What keeps these from being exact: radiance is kept in half floats, whose steps are up to 2^-10 of a value, and a
// device may cut instead of rounding. The G-buffer's 8 bits add nothing where all values are codes: the plane faces
// (1, 1, 1), whose components are equal codes, and is white. What other planes and colours lose has tests of its own.

#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "shading/host.hpp"

namespace velarium::test {
namespace {

constexpr float kTolerance = 1.0f / 1024.0f;  // relative
constexpr float kNothing = 1e-6f;             // W/m^2/sr beside which relative errors mean nothing

constexpr std::uint32_t kSize = 65;  // odd: the middle pixel looks along the axis
constexpr float kCameraDistance = 4.0f, kFovDeg = 60.0f;

// A large plane through the origin, seen head-on.
struct Stage {
  glm::vec3 normal;
  glm::vec3 x, y;  // unit, in the plane: to the picture's right and top

  explicit Stage(const glm::vec3& n) : normal(glm::normalize(n)) {
    const glm::vec3 up = std::abs(normal.y) > 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    x = glm::normalize(glm::cross(up, normal));
    y = glm::cross(normal, x);
  }

  // Metres along x, y and the normal to world space.
  [[nodiscard]] glm::vec3 place(const glm::vec3& p) const { return p.x * x + p.y * y + p.z * normal; }

  [[nodiscard]] RenderRequest request() const {
    RenderRequest request = linear_request(kSize, kSize);
    const glm::vec3 eye = kCameraDistance * normal;
    request.look_at = LookAt{.eye = {eye.x, eye.y, eye.z}, .up = {y.x, y.y, y.z}, .vertical_fov_deg = kFovDeg};
    // One plane alone; that maps say so as well is the business of tests of shadows.
    request.settings.local_shadows.enabled = false;
    return request;
  }

  // The picture of the plane of this material under this light.
  [[nodiscard]] Picture lit(const TestLight& light, const TestMaterial& material = {}) const {
    GltfWriter scene;
    scene.add_quad(scene.add_material(material), glm::vec3(0.0f), normal, glm::vec2(20.0f));
    scene.add_light(light);
    return picture_of(scene.load(), request());
  }
};

const Stage kDiagonal(glm::vec3(1.0f));

// What the middle of pixel (i, j), or a point `offset` pixels beside it, sees of the plane: metres along x and y.
glm::vec3 seen_at(std::uint32_t i, std::uint32_t j, const glm::vec2& offset = glm::vec2(0.0f)) {
  const float half = kCameraDistance * std::tan(glm::radians(0.5f * kFovDeg)), pixel = 2.0f * half / kSize;
  const glm::vec2 place = glm::vec2(i, j) + 0.5f + offset;
  return {place.x * pixel - half, half - place.y * pixel, 0.0f};
}

// Holds every pixel against irradiance(point on the plane) / pi, the mean over the jittered points of all frames.
void expect_irradiance(const Picture& picture, const std::function<float(const glm::vec3&)>& irradiance,
                       std::uint32_t frames = 1) {
  for (std::uint32_t j = 0; j < kSize; ++j) {
    for (std::uint32_t i = 0; i < kSize; ++i) {
      float sum = 0.0f;
      for (std::uint32_t frame = 0; frame < frames; ++frame)
        sum += irradiance(seen_at(i, j, shading::pixel_jitter(frame, frames)));
      const float expected = sum / static_cast<float>(frames) * glm::one_over_pi<float>();
      const float actual = linear_at(picture, i, j).g;
      ASSERT_NEAR(actual, expected, kTolerance * expected + kNothing) << "pixel " << i << ", " << j;
    }
  }
}

float middle(const Picture& picture) {
  return linear_at(picture, kSize / 2, kSize / 2).g;
}

// Illuminance at `p` of one candela at `light`, both in the plane's axes: n.l / d^2.
float of_candela(const glm::vec3& light, const glm::vec3& p) {
  const glm::vec3 way = light - p;
  return way.z / std::pow(glm::length(way), 3.0f);
}

TEST(DirectionalLight, OneLuxHeadOnGivesAlbedoOverPi) {
  const TestLight sun{.type = "directional", .direction = -kDiagonal.normal};
  expect_irradiance(kDiagonal.lit(sun), [](const glm::vec3&) { return 1.0f; });
}

// Albedo is stored in 8 bits, sRGB-encoded; devices may decode it by an approximation that is good to half a step.
TEST(DirectionalLight, AlbedoAndColorMultiply) {
  const glm::vec3 codes(188.0f, 100.0f, 30.0f), color(1.0f, 0.5f, 0.25f);
  const auto albedo = [&](float step) { return shading::srgb_decode((codes + step) / 255.0f); };
  const TestLight sun{.type = "directional", .intensity = 3.0f, .color = color, .direction = -kDiagonal.normal};
  const Picture picture = kDiagonal.lit(sun, {.base_color = glm::vec4(albedo(0.0f), 1.0f)});
  const glm::vec4 actual = linear_at(picture, 10, 20);
  for (int c = 0; c < 3; ++c) {
    const float arriving = 3.0f * color[c] * glm::one_over_pi<float>();
    EXPECT_GE(actual[c], albedo(-0.5f)[c] * arriving) << "channel " << c;
    EXPECT_LE(actual[c], albedo(0.5f)[c] * arriving) << "channel " << c;
  }
  EXPECT_EQ(actual.a, 1.0f);
}

TEST(DirectionalLight, SixtyDegreesHalveIt) {
  const TestLight sun{.type = "directional", .direction = -kDiagonal.place({std::sqrt(0.75f), 0.0f, 0.5f})};
  expect_irradiance(kDiagonal.lit(sun), [](const glm::vec3&) { return 0.5f; });
}

TEST(DirectionalLight, FromBehindGivesNothing) {
  const TestLight sun{.type = "directional", .direction = kDiagonal.place({0.1f, 0.0f, 1.0f})};
  expect_irradiance(kDiagonal.lit(sun), [](const glm::vec3&) { return 0.0f; });
}

// The stored components of a normal are odd multiples of 1 / 255: an axis is off by 1 / 255 in the two others, which
// moves the cosine by at most sqrt(2) sin(60 degrees) / 255.
TEST(DirectionalLight, AxesKeepTheErrorOfStoredNormals) {
  const float error = std::sqrt(2.0f) * std::sqrt(0.75f) / 255.0f;
  for (const glm::vec3& axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1)}) {
    const Stage stage(axis);
    const TestLight sun{.type = "directional", .direction = -stage.place({std::sqrt(0.75f), 0.0f, 0.5f})};
    EXPECT_NEAR(middle(stage.lit(sun)) * glm::pi<float>(), 0.5f, error + 0.5f * kTolerance);
  }
}

TEST(DirectionalLight, BackFacesAreLitOnlyWhereDoubleSided) {
  const Stage back(glm::vec3(-1.0f));
  const TestLight sun{.type = "directional", .direction = -back.normal};
  for (const bool double_sided : {false, true}) {
    GltfWriter scene;
    scene.add_quad(scene.add_material({.double_sided = double_sided}), glm::vec3(0.0f), -back.normal, glm::vec2(20.0f));
    scene.add_light(sun);
    const float expected = double_sided ? glm::one_over_pi<float>() : 0.0f;
    EXPECT_NEAR(middle(picture_of(scene.load(), back.request())), expected, kTolerance);
  }
}

TEST(PointLight, OneCandelaAtTwoMetres) {
  const glm::vec3 above(0.0f, 0.0f, 2.0f);
  const Picture picture = kDiagonal.lit({.type = "point", .position = kDiagonal.place(above)});
  EXPECT_NEAR(middle(picture), 0.25f * glm::one_over_pi<float>(), kTolerance * 0.08f);
  expect_irradiance(picture, [&](const glm::vec3& p) { return of_candela(above, p); });
}

// A light so near that it changes much within a pixel.
TEST(PointLight, FramesSeeJitteredPoints) {
  const glm::vec3 above(0.0f, 0.02f, 0.1f);
  GltfWriter scene;
  scene.add_quad(scene.add_material({}), glm::vec3(0.0f), kDiagonal.normal, glm::vec2(20.0f));
  scene.add_light({.type = "point", .intensity = 0.01f, .position = kDiagonal.place(above)});
  RenderRequest request = kDiagonal.request();
  request.settings.frame.spp = 5;
  expect_irradiance(
      picture_of(scene.load(), request), [&](const glm::vec3& p) { return 0.01f * of_candela(above, p); }, 5);
}

TEST(PointLight, RangeEndsItAsTheExtensionSays) {
  const glm::vec3 above(0.7f, -0.4f, 1.0f);
  constexpr float kRange = 2.0f;
  const Picture picture = kDiagonal.lit({.type = "point", .range = kRange, .position = kDiagonal.place(above)});
  std::size_t dark = 0;
  expect_irradiance(picture, [&](const glm::vec3& p) {
    const float ratio = glm::length(above - p) / kRange;
    if (ratio >= 1.0f) ++dark;
    return of_candela(above, p) * std::max(1.0f - ratio * ratio * ratio * ratio, 0.0f);
  });
  EXPECT_GT(dark, 100u) << "the test must reach beyond the range";
}

TEST(SpotLight, FallsOffBetweenItsConesAsTheExtensionSays) {
  const glm::vec3 above(0.0f, 0.3f, 2.0f);
  constexpr float kInner = 0.25f, kOuter = 0.5f;
  const glm::vec3 axis(0.1f, 0.2f, -1.0f);
  const Picture picture = kDiagonal.lit({.type = "spot",
                                         .intensity = 10.0f,
                                         .inner_cone = kInner,
                                         .outer_cone = kOuter,
                                         .position = kDiagonal.place(above),
                                         .direction = kDiagonal.place(axis)});
  std::size_t inside = 0, between = 0, outside = 0;
  expect_irradiance(picture, [&](const glm::vec3& p) {
    const float cosine = glm::dot(glm::normalize(p - above), glm::normalize(axis));
    const float share = (cosine - std::cos(kOuter)) / (std::cos(kInner) - std::cos(kOuter));
    if (share <= 0.0f)
      ++outside;
    else if (share >= 1.0f)
      ++inside;
    else
      ++between;
    const float kept = std::clamp(share, 0.0f, 1.0f);
    return 10.0f * of_candela(above, p) * kept * kept;
  });
  EXPECT_GT(std::min({inside, between, outside}), 100u) << "the test must see all three";
}

TEST(Lights, AddUpAndCanBeTurnedOff) {
  GltfWriter scene;
  scene.add_quad(scene.add_material({}), glm::vec3(0.0f), kDiagonal.normal, glm::vec2(20.0f));
  for (const float lux : {1.0f, 2.0f, 4.0f})
    scene.add_light({.type = "directional", .intensity = lux, .direction = -kDiagonal.normal});
  const Scene lit = scene.load();
  RenderRequest request = kDiagonal.request();
  expect_irradiance(picture_of(lit, request), [](const glm::vec3&) { return 7.0f; });
  request.settings.lighting.punctual = false;
  expect_irradiance(picture_of(lit, request), [](const glm::vec3&) { return 0.0f; });
}

TEST(Emission, IsNitsTimesStrength) {
  GltfWriter scene;
  const TestMaterial glow{.base_color = {0, 0, 0, 1}, .emissive = {1.0f, 0.5f, 0.25f}, .emissive_strength = 12.0f};
  scene.add_quad(scene.add_material(glow), glm::vec3(0.0f), kDiagonal.normal, glm::vec2(20.0f));
  EXPECT_EQ(linear_at(picture_of(scene.load(), kDiagonal.request()), 3, 60), glm::vec4(12.0f, 6.0f, 3.0f, 1.0f));
}

}  // namespace
}  // namespace velarium::test
