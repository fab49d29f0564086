#include "bake/environment_lobe.hpp"

#include "shading/host.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace velarium::bake {
namespace {

constexpr LobeGrid kGrid{0.2f, 0.1f};
constexpr float kFaceSize = 256.0f;

TEST(CutLobe, CellsCoverTheHemisphereOnce) {
  for (const float alpha : {0.005f, 0.075f, 0.475f, 1.0f}) {
    double weight = 0.0, solid_angle = 0.0;
    for (const auto& s : cut_lobe(alpha, kGrid, kFaceSize)) {
      EXPECT_LE(s.x * s.x + s.y * s.y, 1.0f);
      EXPECT_GE(s.weight, 0.0f);
      weight += s.weight;
      // A cell is as large as a texel of its level, where that is not finer than the source.
      if (s.source_lod > 0.0f)
        solid_angle += 4.0 * M_PI / (6.0 * kFaceSize * kFaceSize) * std::exp2(2.0 * s.source_lod);
    }
    EXPECT_NEAR(weight, 1.0, 1e-5);
    EXPECT_NEAR(solid_angle, 2.0 * M_PI, 0.003 * 2.0 * M_PI) << alpha;  // the unresolved core is smaller than that
  }
}

TEST(CutLobe, MeanCosineIsThatOfTheLobe) {
  for (const float alpha : {0.075f, 0.203f, 1.0f}) {
    double expected = 0.0, norm = 0.0;
    constexpr int kSteps = 100000;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = (i + 0.5) / kSteps * M_PI / 2;
      const double s = std::sin(angle / 2);
      const double w = shading::d_ggx_from_sin2(static_cast<float>(s * s), alpha) * std::cos(angle) * std::sin(angle);
      norm += w;
      expected += w * std::cos(angle);
    }
    double mean = 0.0;
    for (const auto& s : cut_lobe(alpha, kGrid, kFaceSize))
      mean += s.weight * std::sqrt(1.0 - static_cast<double>(s.x) * s.x - static_cast<double>(s.y) * s.y);
    EXPECT_NEAR(mean, expected / norm, 2e-3) << alpha;
  }
}

TEST(CutLobe, CellsHaveNoPreferredSide) {
  double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0;
  for (const auto& s : cut_lobe(0.3f, kGrid, kFaceSize)) {
    x += s.weight * s.x;
    y += s.weight * s.y;
    xx += s.weight * s.x * s.x;
    yy += s.weight * s.y * s.y;
  }
  EXPECT_NEAR(x, 0.0, 1e-5);
  EXPECT_NEAR(y, 0.0, 1e-5);
  EXPECT_NEAR(xx, yy, 1e-5);
}

}  // namespace
}  // namespace velarium::bake
