// The one map of the whole scene: as tight as it can be, as large as memory allows.

#include "passes/far_shadows/far_shadows.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace velarium::far_shadows {
namespace {

const glm::dmat3 kAxes = passes::light_axes(glm::normalize(glm::dvec3(0.3, 1.0, 0.2)));

// A map of a square kilometre has texels of 12.2 cm, and steps of depth of 1.5 cm over a kilometre.
TEST(FarMap, HasTheTexelsOfTheTalk) {
  const passes::LightBox box{{-500.0, -500.0, 0.0}, {500.0, 500.0, 1000.0}};
  const auto map = fit_to(kAxes, box, 8192, 0.0);
  EXPECT_NEAR(map.texel(), 0.1221, 5e-5);
  EXPECT_NEAR((map.z_near - map.z_far) / 65535.0, 0.0153, 5e-5);
}

TEST(FarMap, HoldsAllCastersAndItsGuard) {
  const passes::LightBox box{{-3.0, 10.0, -20.0}, {5.0, 11.0, 30.0}};
  const auto map = fit_to(kAxes, box, 256, 7.0);
  EXPECT_NEAR(map.texel() * (256 - 14), 8.0, 1e-9);  // no larger than it must be
  const double guard = 6.999 * map.texel();
  EXPECT_LE(map.corner.x, box.low.x - guard);
  EXPECT_LE(map.corner.y, box.low.y - guard);
  EXPECT_GE(map.corner.x + map.side, box.high.x + guard);
  EXPECT_GE(map.corner.y + map.side, box.high.y + guard);
  EXPECT_LT(map.z_far, box.low.z);
  EXPECT_GT(map.z_near, box.high.z);
}

// A plane that faces the sun has no depth, one seen edge-on no width, a point nothing.
TEST(FarMap, HasASizeWhereTheSceneHasNone) {
  for (const glm::dvec3& extent : {glm::dvec3(4.0, 4.0, 0.0), glm::dvec3(0.0, 4.0, 1.0), glm::dvec3(0.0)}) {
    const auto map = fit_to(kAxes, {glm::dvec3(1.0), 1.0 + extent}, 512, 2.0);
    EXPECT_GT(map.side, 0.0);
    EXPECT_GT(map.z_near, map.z_far);
    const auto cascade = passes::gpu_cascade(map, glm::dvec3(0.0), {});
    EXPECT_TRUE(std::isfinite(cascade.place.x) && std::isfinite(cascade.depth.x));
  }
}

TEST(FarMap, IsNoLargerThanImagesCanBe) {
  EXPECT_EQ(possible_size(8192, 16384), 8192);
  EXPECT_EQ(possible_size(8192, 4096), 4096);
  EXPECT_EQ(possible_size(6000, 4096), 3000);
}

}  // namespace
}  // namespace velarium::far_shadows
