// Specular anti-aliasing: highlights of a bumpy metal floor, far away, are steady and as bright as the path tracer's.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"
#include "support/temporary_folder.hpp"

#include "shading/host.hpp"

#include <velarium/reference.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace velarium::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kWidth = 96, kHeight = 54;
constexpr std::uint32_t kFrames = 16;

Scene data(const char* name) {
  return Scene::load(fs::path(VELARIUM_TEST_DATA) / name);
}

// The floor from where its bumps are smaller than pixels, with all of the sun's highlight on it. shift: of the picture,
// in pixels.
LookAt far_view(glm::vec2 shift) {
  constexpr float kDistance = 40.0f, kFov = 40.0f;
  const float pixel = 2.0f * std::tan(0.5f * glm::radians(kFov)) * kDistance / static_cast<float>(kHeight);
  return {.eye = {0.0f, 24.0f, 20.0f}, .target = {shift.x * pixel, shift.y * pixel, -12.0f}, .vertical_fov_deg = kFov};
}

RenderRequest far_request(const std::string& options, glm::vec2 shift = glm::vec2(0.0f)) {
  RenderRequest request = linear_request(kWidth, kHeight);
  request.look_at = far_view(shift);
  set_options(request.settings, options);
  return request;
}

using Values = std::vector<double>;

Values luminances(const Picture& picture) {
  Values values;
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x)
      values.push_back(static_cast<double>(shading::luminance(glm::vec3(linear_at(picture, x, y)))));
  return values;
}

double mean_of(const Values& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Of single frames that differ by where in a pixel they look.
struct Flicker {
  double mean = 0.0;      // of all pixels
  double variance = 0.0;  // of a pixel over the frames, the mean of all pixels
};

Flicker flicker_of(const Scene& scene, const std::string& options) {
  Values sums(std::size_t{kWidth} * kHeight), squares(sums.size());
  for (std::uint32_t i = 0; i < kFrames; ++i) {
    const glm::vec2 shift = shading::pixel_jitter(i, kFrames);
    const Values frame = luminances(picture_of(scene, far_request(options, shift)));
    for (std::size_t k = 0; k < frame.size(); ++k) {
      sums[k] += frame[k];
      squares[k] += frame[k] * frame[k];
    }
  }
  Values variances;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const double mean = sums[k] / kFrames;
    variances.push_back(squares[k] / kFrames - mean * mean);
  }
  return {mean_of(sums) / kFrames, mean_of(variances)};
}

double true_mean(const Scene& scene) {
  ReferenceRequest request{.view = far_request("reference.transport=direct reference.spp=1024")};
  return mean_of(luminances(render_reference(scene, request).picture));
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The floor of bumpy_metal.gltf with another roughness.
Scene bumpy_metal(const std::string& perceptual_roughness) {
  std::string text = text_of(fs::path(VELARIUM_TEST_DATA) / "bumpy_metal.gltf");
  const std::string written = "\"roughnessFactor\": 0.4";
  const auto place = text.find(written);
  if (place == std::string::npos) throw std::runtime_error("bumpy_metal.gltf: no " + written);
  text.replace(place, written.size(), "\"roughnessFactor\": " + perceptual_roughness);
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "bumpy_metal.gltf";
  std::ofstream(file) << text;
  return Scene::load(file);
}

struct Bumpy {
  const char* perceptual_roughness;
  double flicker;  // at least: variance with the option off over that with it on
};

void PrintTo(const Bumpy& bumpy, std::ostream* out) {
  *out << bumpy.perceptual_roughness;
}

class BumpyMetal : public testing::TestWithParam<Bumpy> {};

TEST_P(BumpyMetal, IsSteadyAndAsBrightAsItIs) {
  const Scene scene = bumpy_metal(GetParam().perceptual_roughness);
  const double truth = true_mean(scene);
  const Flicker off = flicker_of(scene, "specular_aa.baked=off specular_aa.screen=off");
  const Flicker on = flicker_of(scene, "");
  RecordProperty("variance_ratio", std::to_string(off.variance / on.variance));
  RecordProperty("mean_ratio", std::to_string(on.mean / truth));
  RecordProperty("mean_ratio_off", std::to_string(off.mean / truth));
  EXPECT_NEAR(on.mean, truth, 0.02 * truth);
  EXPECT_GT(off.mean, 1.06 * truth);
  EXPECT_GT(off.variance, GetParam().flicker * on.variance);
}

INSTANTIATE_TEST_SUITE_P(SpecularAntiAliasing, BumpyMetal, testing::Values(Bumpy{"0.2", 60.0}, Bumpy{"0.4", 2.5}));

// What the G-buffer holds of smoothness.
std::vector<float> smoothness_of(const Scene& scene, RenderRequest request, const std::string& options) {
  set_options(request.settings, options);
  request.dumps = {"gbuffer.specular"};
  const auto result = engine().render(scene, request);
  std::vector<float> values;
  for (std::size_t i = 0; i < result.dumps.front().rgba.size(); i += 4) values.push_back(result.dumps.front().rgba[i]);
  return values;
}

TEST(SpecularAntiAliasing, FlatSurfacesStayAsTheyAre) {
  GltfWriter writer;
  const int mirror = writer.add_material({.metallic = 1.0f, .perceptual_roughness = 0.1f});
  writer.add_quad(mirror, {0, 0, -20}, {0, 1, 0}, {200, 60});
  writer.add_quad(mirror, {0, 1, -5}, {1, 0, 1}, {2, 2});
  const Scene scene = writer.load();
  RenderRequest request = linear_request(64, 48);
  request.look_at = LookAt{.eye = {0, 1.5f, 2}, .target = {0, 0.8f, -5}};
  // Where the two meet, edges may differ in depth by less than the filter's reach; elsewhere nothing may change.
  const auto off = smoothness_of(scene, request, "specular_aa.screen=off");
  const auto on = smoothness_of(scene, request, "specular_aa.screen=on specular_aa.strength=16");
  std::size_t changed = 0;
  for (std::size_t i = 0; i < on.size(); ++i) changed += on[i] != off[i] ? 1u : 0u;
  EXPECT_LT(changed, 64u);  // two rows of the seam
}

// A ball of 20 pixels' radius turns the faster the nearer its rim.
TEST(SpecularAntiAliasing, BallsAreRougherTowardsTheRim) {
  RenderRequest request = linear_request(64, 64);
  // The third ball: metal of perceptual roughness 0.2, half a metre left of and below the middle.
  const float half_height = 0.48f * 32.0f / 20.0f, distance = 8.0f;
  request.look_at = LookAt{.eye = {-0.5f, -0.5f, distance},
                           .target = {-0.5f, -0.5f, 0.0f},
                           .vertical_fov_deg = 2.0f * glm::degrees(std::atan(half_height / distance))};
  const auto s =
      smoothness_of(data("metallic_roughness.gltf"), request, "specular_aa.screen=on specular_aa.strength=4.8");
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return s[64 * y + x]; };
  for (std::uint32_t x = 33; x < 50; ++x) EXPECT_LE(at(x, 32), at(x - 1, 32) + 2.5f / 255.0f) << x;
  // Five taps of normals that turn by gx and gy a pixel: 2 v = 0.4 (gx^2 + gy^2), on alpha 0.04. In the middle both are
  // 1/20, which makes an alpha of 0.060; 17 pixels from there gx is 1/20 over 0.527, the cosine, which makes 0.078.
  EXPECT_NEAR(at(32, 32), shading::smoothness_from_alpha(0.060f), 0.015f);
  EXPECT_NEAR(at(49, 32), shading::smoothness_from_alpha(0.078f), 0.015f);
}

TEST(SpecularAntiAliasing, OffIsOff) {
  const Scene scene = data("bumpy_metal.gltf");
  const auto request = far_request("");
  const auto off = smoothness_of(scene, request, "specular_aa.screen=off specular_aa.baked=off");
  const auto none = smoothness_of(scene, request, "specular_aa.screen=on specular_aa.strength=0 specular_aa.baked=off");
  EXPECT_TRUE(off == none);
}

}  // namespace
}  // namespace velarium::test
