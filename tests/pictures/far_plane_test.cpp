// Perspective cameras that end: what lies beyond zfar is in no picture of either renderer (glTF 2.0, 3.10.3.3).

#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <velarium/reference.hpp>

#include <gtest/gtest.h>

namespace velarium::test {
namespace {

// Two glowing squares, one behind the other and a little larger, seen by a camera that ends at `far_m`; 0: nowhere.
Scene squares(float far_m) {
  SceneDescription scene;
  for (const float distance : {2.0f, 4.0f}) {
    const float half = 0.3f * distance * distance / 2.0f;
    scene.materials.push_back({.base_color = {0, 0, 0, 1}, .emissive = {distance, 1, 0}});
    scene.meshes.push_back({.positions = {{-half, -half, -distance},
                                          {half, -half, -distance},
                                          {half, half, -distance},
                                          {-half, half, -distance}},
                            .indices = {0, 1, 2, 0, 2, 3},
                            .material = static_cast<std::uint32_t>(scene.meshes.size())});
  }
  scene.cameras.push_back({.view = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov_deg = 90}, .far_m = far_m});
  return Scene::make(scene);
}

constexpr std::uint32_t kSize = 41, kMiddle = 20, kBeside = 10;  // where only the far square is

float red(const Picture& picture, std::uint32_t x) {
  return linear_at(picture, x, kMiddle).x;
}

TEST(FarPlane, EndsPerspectiveViews) {
  const RenderRequest request = linear_request(kSize, kSize);
  for (const auto& [far_m, beside] : {std::pair{0.0f, 4.0f}, {5.0f, 4.0f}, {3.0f, 0.0f}}) {
    const Scene scene = squares(far_m);
    for (const Picture& picture : {picture_of(scene, request), render_reference(scene, {.view = request}).picture}) {
      EXPECT_NEAR(red(picture, kMiddle), 2.0f, 1e-3f) << far_m;
      EXPECT_NEAR(red(picture, kBeside), beside, 1e-3f) << far_m;
    }
  }
}

TEST(FarPlane, ChangesNothingBeforeIt) {
  const RenderRequest request = linear_request(kSize, kSize);
  EXPECT_LE(largest_error(picture_of(squares(0.0f), request).linear, picture_of(squares(100.0f), request).linear),
            1e-3);
}

}  // namespace
}  // namespace velarium::test
