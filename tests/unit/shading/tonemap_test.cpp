#include <gtest/gtest.h>

#include <velarium/settings.hpp>

#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

constexpr uint kCurves[] = {kTonemapNeutral, kTonemapAgx, kTonemapAces, kTonemapLinear};

TEST(Color, SrgbTransferFunction) {
  EXPECT_NEAR(srgb_encode(vec3(0.18f)).x, 0.461356f, 1e-5);
  EXPECT_NEAR(srgb_decode(vec3(0.5f)).x, 0.214041f, 1e-5);
  EXPECT_NEAR(srgb_encode(vec3(0.002f)).x, 0.02584f, 1e-6);
  EXPECT_EQ(srgb_encode(vec3(-1.0f)), vec3(0.0f));
  EXPECT_NEAR(srgb_encode(vec3(1.0f)).y, 1.0f, 1e-6);
  for (int i = 0; i <= 255; ++i) {
    const float code = static_cast<float>(i) / 255.0f;
    EXPECT_NEAR(srgb_encode(srgb_decode(vec3(code))).z, code, 1e-6);
  }
}

TEST(Color, LuminanceOfWhiteIsOne) {
  EXPECT_NEAR(luminance(vec3(1.0f)), 1.0f, 1e-6);
  EXPECT_NEAR(luminance(vec3(0, 1, 0)), 0.7152f, 1e-6);
}

TEST(Exposure, FollowsEv100) {
  EXPECT_NEAR(exposure_from_ev100(0.0f), 0.8333333f, 1e-6);
  EXPECT_NEAR(exposure_from_ev100(15.0f), 2.54313e-5f, 1e-9);
}

TEST(Tonemap, OrderIsThatOfTheSettings) {
  EXPECT_EQ(kTonemapNeutral, static_cast<uint>(Tonemap::neutral));
  EXPECT_EQ(kTonemapAgx, static_cast<uint>(Tonemap::agx));
  EXPECT_EQ(kTonemapAces, static_cast<uint>(Tonemap::aces));
  EXPECT_EQ(kTonemapLinear, static_cast<uint>(Tonemap::linear));
  EXPECT_EQ(kModelGltf, static_cast<uint>(ShadingModel::gltf));
  EXPECT_EQ(kModelRyse, static_cast<uint>(ShadingModel::ryse));
  EXPECT_EQ(kModelBlinnPhong, static_cast<uint>(ShadingModel::blinn_phong));
}

TEST(Tonemap, NeutralKeepsBaseColors) {
  // Reflected white of albedo c arrives as c + 0.04, and leaves as c.
  for (const float albedo : {0.1f, 0.18f, 0.5f, 0.7f}) {
    EXPECT_NEAR(tonemap_neutral(vec3(albedo + 0.04f)).x, albedo, 1e-6);
  }
  EXPECT_NEAR(tonemap_neutral(vec3(0.04f)).x, 0.01f, 1e-6);
  EXPECT_NEAR(tonemap_neutral(vec3(1.0f)).x, 0.869091f, 1e-6);  // 1 - 0.24^2 / 0.44
  const vec3 bright_red = tonemap_neutral(vec3(20.0f, 1.0f, 1.0f));
  EXPECT_GT(bright_red.y, 0.6f);  // highlights turn to white
}

TEST(Tonemap, AgxPassesItsPivot) {
  // The curve is made so that 18 % grey leaves at code value 1/2; the polynomial errs a little.
  EXPECT_NEAR(std::pow(tonemap_agx(vec3(0.18f)).x, 1.0f / 2.2f), 0.5f, 4e-3);
  EXPECT_NEAR(tonemap_agx(vec3(1e4f)).x, 1.0f, 5e-3);
  const vec3 grey = tonemap_agx(vec3(0.5f));
  EXPECT_NEAR(grey.x, grey.y, 2e-3);
  EXPECT_NEAR(grey.x, grey.z, 2e-3);
}

TEST(Tonemap, AcesIsTheRationalCurveOnGreys) {
  const auto curve = [](double v) {
    v /= 0.6;
    return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  };
  for (const float v : {0.02f, 0.18f, 1.0f, 4.0f}) EXPECT_NEAR(tonemap_aces(vec3(v)).y, curve(v), 1e-4) << v;
  EXPECT_NEAR(tonemap_aces(vec3(0.18f)).x, 0.2131f, 1e-4);
}

TEST(Tonemap, CurvesStayOnTheDisplayAndRise) {
  for (const uint curve : kCurves) {
    EXPECT_LT(tonemap(curve, vec3(0.0f)).x, 1e-5f);
    float last = -1.0f;
    for (float v = 1e-3f; v < 1e4f; v *= 1.2f) {
      const float out = tonemap(curve, vec3(v)).x;
      EXPECT_GE(out, last - 1e-6f) << curve << ' ' << v;
      last = out;
    }
    Random random(3);
    for (int i = 0; i < 10000; ++i) {
      const vec3 out = tonemap(curve, random.color() * std::exp(random.uniform(-8.0f, 8.0f)));
      ASSERT_TRUE(min_component(out) >= 0.0f && max_component(out) <= 1.0f) << curve;
    }
  }
}

TEST(Tonemap, LinearOnlyClips) {
  EXPECT_EQ(tonemap(kTonemapLinear, vec3(-1.0f, 0.4f, 3.0f)), vec3(0.0f, 0.4f, 1.0f));
}

}  // namespace
}  // namespace velarium::shading
