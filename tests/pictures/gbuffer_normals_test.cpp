// Floors and walls along the axes reflect as if nothing had rounded their normals.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::test {
namespace {

constexpr std::uint32_t kSize = 48;

// A plane of polished metal, a lamp a metre above its middle, and an eye above the lamp that sees parallel lines.
// Half vectors lean by half of the distance to the middle: by 0.025 at the picture's edges, 2.5 times the lobe's alpha.
Picture highlight(const glm::vec3& normal) {
  GltfWriter scene;
  const int metal = scene.add_material({.metallic = 1.0f, .perceptual_roughness = 0.1f, .specular = 1.0f});
  scene.add_quad(metal, {0, 0, 0}, normal, {1, 1});
  scene.add_light({.position = normal});
  scene.add_orthographic_camera(2.0f * normal, {0, 0, 0}, 0.05f, 4.0f);
  return picture_of(scene.load(), linear_request(kSize, kSize));
}

// A normal that leans by one code of 8 bits, 0.004, puts it five pixels beside the middle.
TEST(AxisNormals, HighlightsLieStraightBelowTheirLamps) {
  for (const glm::vec3 normal : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(-1, 0, 0),
                                 glm::vec3(0, -1, 0), glm::vec3(0, 0, -1)}) {
    const Picture picture = highlight(normal);
    const auto at = [&](std::uint32_t x, std::uint32_t y) { return linear_at(picture, x, y).y; };
    EXPECT_GT(at(kSize / 2, kSize / 2), 10.0f * at(0, 0)) << "no highlight";
    float worst = 0.0f;  // of what a pixel and its mirror images differ by, as a share
    for (std::uint32_t y = 0; y < kSize; ++y) {
      for (std::uint32_t x = 0; x < kSize; ++x) {
        const float value = at(x, y);
        for (const float mirrored : {at(kSize - 1 - x, y), at(x, kSize - 1 - y), at(y, x)})
          worst = std::max(worst, std::abs(mirrored / value - 1.0f));
      }
    }
    // Pictures are half floats. Places, to a few units of fp32 in a metre, are a thousandth of a pixel.
    EXPECT_LT(worst, 0.005f) << normal.x << ' ' << normal.y << ' ' << normal.z;
  }
}

}  // namespace
}  // namespace velarium::test
