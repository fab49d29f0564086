#include <glm/vector_relational.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

vec3 codes_of(const vec3& f0) {
  const vec3 stored = unorm8(specular_encode(f0));
  return {code8(stored.x), code8(stored.y), code8(stored.z)};
}

void expect_color_near(const vec3& a, const vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(SpecularEncoding, KnownCodes) {
  EXPECT_EQ(codes_of(vec3(0.04f)), vec3(51, 128, 128));
  EXPECT_EQ(codes_of(vec3(1.0f, 0.766f, 0.336f)), vec3(225, 87, 147));
  expect_color_near(specular_decode(vec3(51, 128, 128) / 255.0f), vec3(0.04f), 1e-6);
  expect_color_near(specular_decode(vec3(225, 87, 147) / 255.0f), vec3(0.9994f, 0.7702f, 0.3411f), 1e-4);
}

TEST(SpecularEncoding, WorstErrorOverTheColorCube) {
  float worst = 0.0f;
  for (int i = 0; i < 25 * 25 * 25; ++i) {
    const vec3 f0 = vec3(i % 25, i / 25 % 25, i / 625) / 24.0f;
    const vec3 error = glm::abs(glm::sqrt(specular_decode(unorm8(specular_encode(f0)))) - glm::sqrt(f0));
    worst = std::max(worst, max_component(error));
  }
  EXPECT_NEAR(worst, 0.0055f, 5e-5);
}

// A decal of f0 0.04 at half opacity: blending hardware reaches Y and Cb, and leaves Cr, in alpha, as it was.
TEST(SpecularEncoding, DecalsBlendWithoutAlpha) {
  const auto blend = [](const vec3& under, bool alpha_too) {
    const vec3 u = unorm8(specular_encode(under)), o = unorm8(specular_encode(vec3(0.04f)));
    const vec3 both = 0.5f * (u + o);
    return specular_decode({both.x, both.y, alpha_too ? both.z : u.z});
  };
  const vec3 plastic = blend(vec3(0.1f), false);
  EXPECT_NEAR(plastic.x, plastic.y, 1e-5);
  EXPECT_NEAR(plastic.z, plastic.y, 1e-5);
  const vec3 gold{1.0f, 0.766f, 0.336f};
  expect_color_near(blend(gold, false), {0.434f, 0.272f, 0.154f}, 6e-4);
  expect_color_near(blend(gold, true), {0.360f, 0.290f, 0.154f}, 6e-4);
}

// What the three targets keep: RT1 is sRGB.
GBufferTexel through_targets(const GBufferTexel& t) {
  const vec3 albedo = unorm8(srgb_encode({t.albedo.x, t.albedo.y, t.albedo.z}));
  return {unorm8(t.normal), vec4(srgb_decode(albedo), unorm8(t.albedo.w)), unorm8(t.specular)};
}

Surface random_surface(Random& random, uint material_class) {
  Surface s;
  s.normal_ws = random.direction();
  s.albedo = random.color();
  s.f0 = material_class == kClassTransmittance ? vec3(random.uniform()) : random.color();
  s.smoothness = random.uniform();
  s.occlusion = material_class == kClassTransmittance ? 1.0f : random.uniform();
  const vec3 transmittance = material_class == kClassTransmittance ? ycbcr_from_linear(random.color()) : vec3(0.0f);
  s.transmittance_luma = transmittance.x;
  s.transmittance_chroma = {transmittance.y, transmittance.z};
  s.material_class = material_class;
  return s;
}

constexpr float kHalfStep = 0.5f / 255.0f + 1e-6f;

void expect_preserved(const Surface& in, const Surface& out) {
  ASSERT_LT(angle_degrees(in.normal_ws, out.normal_ws), kWorstNormalError);
  ASSERT_LT(max_component(glm::abs(srgb_encode(in.albedo) - srgb_encode(out.albedo))), kHalfStep);
  ASSERT_LT(max_component(glm::abs(glm::sqrt(in.f0) - glm::sqrt(out.f0))), 0.006f);
  ASSERT_LT(std::abs(in.smoothness - out.smoothness), kHalfStep);
  ASSERT_LT(std::abs(in.occlusion - out.occlusion), kHalfStep);
  ASSERT_LT(std::abs(in.transmittance_luma - out.transmittance_luma), kHalfStep);
  // Chroma of exactly +1/2 lies half a code beyond the last one.
  ASSERT_LT(length(in.transmittance_chroma - out.transmittance_chroma), 1.5f / 255.0f);
  ASSERT_EQ(in.material_class, out.material_class);
}

TEST(GBuffer, KeepsRandomSurfaces) {
  Random random(9);
  for (int i = 0; i < 100000; ++i) {
    const Surface in = random_surface(random, static_cast<uint>(i % 4));
    const float table_value = static_cast<float>(best_fit_length(in.normal_ws)) / 255.0f;
    const GBufferTexel texel = gbuffer_encode(in, table_value);
    for (const vec4& rt : {texel.normal, texel.albedo, texel.specular}) {
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(rt, vec4(-1e-6f))) &&
                  glm::all(glm::lessThanEqual(rt, vec4(1.000001f))));
    }
    expect_preserved(in, gbuffer_decode(through_targets(texel), in.material_class));
    if (HasFatalFailure()) return;
  }
}

// The surface that `count` frames see on average.
Surface mean_of_frames(const Surface& in, uint count) {
  const float table_value = static_cast<float>(best_fit_length(in.normal_ws)) / 255.0f;
  Surface mean{};
  for (uint i = 0; i < count; ++i) {
    const GBufferTexel texel = gbuffer_shifted(gbuffer_encode(in, table_value), rounding_shift(i, count));
    const Surface out = gbuffer_decode(through_targets(texel), in.material_class);
    const float share = 1.0f / static_cast<float>(count);
    mean.normal_ws += share * out.normal_ws;
    mean.albedo += share * out.albedo;
    mean.f0 += share * out.f0;
    mean.smoothness += share * out.smoothness;
    mean.occlusion += share * out.occlusion;
  }
  return mean;
}

TEST(GBuffer, FramesKnowWhatLiesBetweenCodes) {
  // A sixteenth of a code is as near as 16 roundings come. Theirs lie about, not on, a regular grid: three times that.
  constexpr float kStep = 3.0f / 16.0f / 255.0f;
  Random random(11);
  float worst = 0.0f;
  for (int i = 0; i < 10000; ++i) {
    Surface in = random_surface(random, 0u);
    in.albedo = glm::max(in.albedo, vec3(0.05f));
    in.f0 = glm::max(in.f0, vec3(0.04f));
    const Surface mean = mean_of_frames(in, 16u);
    // Blue has the largest share of errors: luma's, and 1.8556 of a chroma's.
    ASSERT_LT(max_component(glm::abs(glm::sqrt(in.f0) - glm::sqrt(mean.f0))), 2.8556f * kStep);
    worst = std::max(worst, max_component(glm::abs(srgb_encode(in.albedo) - srgb_encode(mean.albedo))));
    ASSERT_LT(std::abs(in.smoothness - mean.smoothness), kStep);
    ASSERT_LT(std::abs(in.occlusion - mean.occlusion), kStep);
    ASSERT_LT(angle_degrees(in.normal_ws, mean.normal_ws), kWorstNormalError);
  }
  EXPECT_LT(worst, kStep);
}

// As integers, so that no frame moves them.
TEST(GBuffer, EveryFrameKeepsAxes) {
  Surface s{};
  for (const uint count : {1u, 2u, 16u, 64u}) {
    for (uint frame = 0; frame < count; ++frame) {
      for (int axis = 0; axis < 6; ++axis) {
        s.normal_ws = vec3(0.0f);
        s.normal_ws[axis % 3] = axis < 3 ? 1.0f : -1.0f;
        const GBufferTexel texel = gbuffer_shifted(gbuffer_encode(s, 127.0f / 255.0f), rounding_shift(frame, count));
        ASSERT_EQ(gbuffer_decode(through_targets(texel), kClassStandard).normal_ws, s.normal_ws)
            << frame << ' ' << count;
      }
    }
  }
}

// What normal maps have for flat, (128, 128, 255), lies within a hundredth of halfway between 0 and 1.
TEST(GBuffer, FramesKnowNormalsHalfwayBetweenCodes) {
  Surface s{};
  s.normal_ws = normalize(vec3(1.0f, 1.0f, 255.0f));
  EXPECT_GT(angle_degrees(s.normal_ws, normalize(mean_of_frames(s, 1u).normal_ws)), 0.3);
  EXPECT_LT(angle_degrees(s.normal_ws, normalize(mean_of_frames(s, 16u).normal_ws)), 0.05);
}

TEST(GBuffer, OneFrameKeepsTheNearestCodes) {
  Random random(12);
  for (int i = 0; i < 1000; ++i) {
    const GBufferTexel texel = gbuffer_encode(random_surface(random, 0u), 1.0f);
    const GBufferTexel moved = gbuffer_shifted(texel, rounding_shift(0u, 1u));
    ASSERT_EQ(moved.normal, texel.normal);
    ASSERT_LT(glm::length(moved.albedo - texel.albedo), 1e-6f);
    ASSERT_EQ(moved.specular, texel.specular);
  }
}

TEST(GBuffer, TransmittingSurfacesHaveGreySpecular) {
  Random random(10);
  Surface s = random_surface(random, kClassTransmittance);
  s.f0 = vec3(0.9f, 0.3f, 0.1f);
  const Surface back = gbuffer_decode(through_targets(gbuffer_encode(s, 1.0f)), kClassTransmittance);
  EXPECT_NEAR(back.f0.x, back.f0.y, 1e-5);
  EXPECT_NEAR(back.f0.z, back.f0.y, 1e-5);
  EXPECT_NEAR(std::sqrt(back.f0.y), luminance(glm::sqrt(s.f0)), kHalfStep);
}

}  // namespace
}  // namespace velarium::shading
