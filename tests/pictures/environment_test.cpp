// Where an environment's light comes from: docs/conventions.md, "Environment".

#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>

namespace velarium::test {
namespace {

constexpr std::uint32_t kWidth = 64, kHeight = 32;

// Six patches of different colours about the axes, black between them.
image::FloatImage axes_environment() {
  struct Patch {
    std::uint32_t x, y;  // middle, pixels
    glm::vec3 color;
  };
  // The middle is +X, a quarter to its right +Z, a quarter to its left -Z; the top row +Y.
  const Patch patches[] = {{kWidth / 2, kHeight / 2, {1, 0, 0}},
                           {3 * kWidth / 4, kHeight / 2, {0, 0, 1}},
                           {kWidth / 4, kHeight / 2, {1, 1, 0}},
                           {0, kHeight / 2, {0, 1, 1}},
                           {kWidth, kHeight / 2, {0, 1, 1}}};
  image::FloatImage image{kWidth, kHeight, std::vector<float>(std::size_t{4} * kWidth * kHeight, 0.0f)};
  const auto paint = [&](std::uint32_t x, std::uint32_t y, const glm::vec3& color) {
    float* pixel = &image.rgba[4 * (std::size_t{y} * kWidth + x)];
    for (int c = 0; c < 3; ++c) pixel[c] = color[c];
    pixel[3] = 1.0f;
  };
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      paint(x, y, y < 4 ? glm::vec3(0, 1, 0) : y >= kHeight - 4 ? glm::vec3(1, 0, 1) : glm::vec3(0.0f));
      for (const Patch& patch : patches)
        if (std::abs(int(x) + 0.5f - float(patch.x)) < 4.0f && std::abs(int(y) + 0.5f - float(patch.y)) < 4.0f)
          paint(x, y, patch.color);
    }
  }
  return image;
}

class AxesEnvironment : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    file_ = std::filesystem::temp_directory_path() / ("velarium-axes-" + std::to_string(getpid()) + ".exr");
    image::save_exr(file_, axes_environment(), false);
  }
  static void TearDownTestSuite() { std::filesystem::remove(file_); }

  static RenderRequest request(float rotation_deg) {
    RenderRequest request = linear_request(15, 15);
    request.environment = file_.string();
    request.settings.environment.rotation = rotation_deg;
    return request;
  }

  // The view from `eye` to `target`, along one of the axes.
  static LookAt along(const glm::vec3& eye, const glm::vec3& target) {
    const bool vertical = eye.y != target.y;
    return {.eye = {eye.x, eye.y, eye.z},
            .target = {target.x, target.y, target.z},
            .up = {0.0f, vertical ? 0.0f : 1.0f, vertical ? 1.0f : 0.0f},
            .vertical_fov_deg = 20.0f};
  }

  // What lies in this direction.
  static glm::vec3 seen(const glm::vec3& direction, float rotation_deg = 0.0f) {
    RenderRequest view = request(rotation_deg);
    view.look_at = along(glm::vec3(0.0f), direction);
    return linear_at(picture_of(GltfWriter().load(), view), 7, 7);
  }

  // What a surface that faces this way reflects back along its normal.
  static glm::vec3 reflected(const glm::vec3& normal, const TestMaterial& material, float rotation_deg = 0.0f) {
    GltfWriter scene;
    scene.add_quad(scene.add_material(material), {0, 0, 0}, normal, {4, 4});
    RenderRequest view = request(rotation_deg);
    view.look_at = along(normal, glm::vec3(0.0f));
    return linear_at(picture_of(scene.load(), view), 7, 7);
  }

  static inline std::filesystem::path file_;
};

const glm::vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

TEST_F(AxesEnvironment, AxesAreWhereTheConventionSays) {
  EXPECT_EQ(seen(kX), glm::vec3(1, 0, 0));
  EXPECT_EQ(seen(kZ), glm::vec3(0, 0, 1));
  EXPECT_EQ(seen(-kZ), glm::vec3(1, 1, 0));
  EXPECT_EQ(seen(-kX), glm::vec3(0, 1, 1));
  EXPECT_EQ(seen(kY), glm::vec3(0, 1, 0));
  EXPECT_EQ(seen(-kY), glm::vec3(1, 0, 1));
}

// A positive turn about +Y in a right-handed world: +Z goes to +X, and +X to -Z.
TEST_F(AxesEnvironment, RotationTurnsItAboutUp) {
  EXPECT_EQ(seen(-kZ, 90.0f), glm::vec3(1, 0, 0));
  EXPECT_EQ(seen(kX, 90.0f), glm::vec3(0, 0, 1));
  EXPECT_EQ(seen(kZ, 90.0f), glm::vec3(0, 1, 1));
  EXPECT_EQ(seen(kZ, -90.0f), glm::vec3(1, 0, 0));
  EXPECT_EQ(seen(-kX, 180.0f), glm::vec3(1, 0, 0));
  EXPECT_EQ(seen(kY, 90.0f), glm::vec3(0, 1, 0));
}

TEST_F(AxesEnvironment, MirrorsShowWhatLiesBehindTheViewer) {
  const TestMaterial mirror{.metallic = 1.0f, .perceptual_roughness = 0.0f};
  const auto expect_hue = [](const glm::vec3& actual, const glm::vec3& expected) {
    // Level 0 of the prefiltered cube has the width of its texels.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 0.02f) << "channel " << c;
  };
  expect_hue(reflected(kX, mirror), {1, 0, 0});
  expect_hue(reflected(kZ, mirror), {0, 0, 1});
  expect_hue(reflected(kY, mirror), {0, 1, 0});
  expect_hue(reflected(-kX, mirror), {0, 1, 1});
  expect_hue(reflected(-kZ, mirror, 90.0f), {1, 0, 0});
  expect_hue(reflected(kX, mirror, 90.0f), {0, 0, 1});
}

TEST_F(AxesEnvironment, DiffuseLightComesFromTheSameSide) {
  const auto dominates = [](const glm::vec3& light, const glm::vec3& hue) {
    for (int c = 0; c < 3; ++c)
      for (int other = 0; other < 3; ++other)
        if (hue[c] > hue[other]) { EXPECT_GT(light[c], 2.0f * light[other]); }
  };
  dominates(reflected(kX, {}), {1, 0, 0});
  dominates(reflected(kZ, {}), {0, 0, 1});
  dominates(reflected(-kZ, {}, 90.0f), {1, 0, 0});
  dominates(reflected(kX, {}, 90.0f), {0, 0, 1});
}

TEST_F(AxesEnvironment, IntensityMultiplies) {
  RenderRequest view = request(0.0f);
  view.look_at = along(glm::vec3(0.0f), kX);
  view.settings.environment.intensity = 2.5f;
  EXPECT_EQ(linear_at(picture_of(GltfWriter().load(), view), 7, 7), glm::vec4(2.5f, 0, 0, 1));
}

}  // namespace
}  // namespace velarium::test
