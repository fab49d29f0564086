#include "reference/environment_light.hpp"

#include "bake/environment_texels.hpp"
#include "bake/irradiance.hpp"
#include "statistical/chi_squared.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>

namespace velarium::statistical {
namespace {

using image::FloatImage;
using reference::EnvironmentLight;

vec3 pixel_direction(const FloatImage& image, std::uint32_t x, std::uint32_t y) {
  return shading::equirect_direction((vec2(x, y) + 0.5f) / vec2(image.width, image.height));
}

FloatImage make_picture(std::uint32_t width, std::uint32_t height, const std::function<vec3(const vec3&)>& radiance) {
  FloatImage image{width, height, {}};
  image.rgba.resize(std::size_t{4} * width * height, 1.0f);
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const vec3 value = radiance(pixel_direction(image, i % width, i / width));
    std::copy_n(&value.x, 3, &image.rgba[std::size_t{4} * i]);
  }
  return image;
}

// Unrelated pixels, a third of them black.
FloatImage rough_picture() {
  Random random(8);
  return make_picture(16, 8,
                      [&](const vec3&) { return random.uniform() < 0.33f ? vec3(0.0f) : 5.0f * random.color(); });
}

// Black but for one pixel.
FloatImage lone_lamp() {
  FloatImage image = make_picture(32, 16, [](const vec3&) { return vec3(0.0f); });
  std::fill_n(&image.rgba[4 * (5 * 32 + 31)], 3, 1000.0f);
  return image;
}

FloatImage gradient() {
  return make_picture(128, 64, [](const vec3& d) { return vec3(1.0f + d.x, 1.0f + d.y, 1.0f + 0.5f * d.z); });
}

float half_to_float(std::uint16_t bits) {
  const int exponent = bits >> 10;
  const float mantissa = static_cast<float>(bits & 0x3ff) / 1024.0f;
  return exponent == 0 ? std::ldexp(mantissa, -14) : std::ldexp(1.0f + mantissa, exponent - 15);
}

vec2 uniform_2d(Random& random) {
  const float x = random.uniform();
  return {x, random.uniform()};
}

// In the middle of a pixel the tracer reads what the renderer's background texture holds there.
TEST(EnvironmentLight, ReadsWhatTheRendererBakes) {
  const FloatImage picture = rough_picture();
  const auto baked = bake::half_mips(picture);
  const EnvironmentLight light(picture, 0.0f, 2.0f);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const vec3 radiance = light.radiance(pixel_direction(picture, x, y));
      for (int k = 0; k < 3; ++k) {
        const float half = half_to_float(baked[4 * (std::size_t{y} * picture.width + x) + static_cast<std::size_t>(k)]);
        ASSERT_NEAR(radiance[k], 2.0f * half, 2.0 * half / 2048.0 + 1e-4) << x << ' ' << y;
      }
    }
  }
}

// Half way between two pixels, around the seam as well, it reads their mean; beyond the last row, the last row.
TEST(EnvironmentLight, InterpolatesBetweenCentres) {
  const FloatImage picture = rough_picture();
  const EnvironmentLight light(picture, 0.0f, 1.0f);
  const auto pixel = [&](std::uint32_t x, std::uint32_t y) { return picture.rgba[4 * (y * 16 + x)]; };
  const auto read = [&](float x, float y) {
    return light.radiance(shading::equirect_direction({x / 16.0f, y / 8.0f})).x;
  };
  EXPECT_NEAR(read(4.0f, 3.5f), 0.5f * (pixel(3, 3) + pixel(4, 3)), 1e-4);
  EXPECT_NEAR(read(7.5f, 5.0f), 0.5f * (pixel(7, 4) + pixel(7, 5)), 1e-4);
  EXPECT_NEAR(read(0.001f, 2.5f), 0.5f * (pixel(15, 2) + pixel(0, 2)), 1e-2);
  EXPECT_NEAR(read(15.999f, 2.5f), 0.5f * (pixel(15, 2) + pixel(0, 2)), 1e-2);
  EXPECT_NEAR(read(9.5f, 0.2f), pixel(9, 0), 1e-4);
  EXPECT_NEAR(read(9.5f, 7.9f), pixel(9, 7), 1e-4);
}

// docs/conventions.md: counter-clockwise seen from above; by 90 degrees, what was at +Z is at +X.
TEST(EnvironmentLight, TurnsAsDocumented) {
  const FloatImage picture =
      make_picture(64, 32, [](const vec3& d) { return glm::max(d, 0.0f) + glm::max(-d, 0.0f) * 0.1f; });
  const EnvironmentLight still(picture, 0.0f, 1.0f), turned(picture, 90.0f, 1.0f);
  EXPECT_LT(glm::length(turned.radiance({1, 0, 0}) - still.radiance({0, 0, 1})), 1e-4f);
  EXPECT_LT(glm::length(turned.radiance({0, 0, 1}) - still.radiance({-1, 0, 0})), 1e-4f);
  EXPECT_LT(glm::length(turned.radiance({0.6f, 0.8f, 0}) - still.radiance({0, 0.8f, 0.6f})), 1e-4f);
}

vec3 sampled_irradiance(const EnvironmentLight& light, const vec3& normal) {
  constexpr std::uint32_t kSamples = 1u << 14;
  glm::dvec3 sum(0.0);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto sample = light.sample(shading::scrambled_sobol_2d(i, 1u));
    sum += glm::dvec3(sample.radiance * (std::max(glm::dot(sample.wi, normal), 0.0f) / sample.pdf_sr));
  }
  return vec3(sum / (kSamples * shading::kPiExact));
}

// Under radiance 1 + a.d, irradiance / pi is 1 + 2/3 a.n; and the renderer's own integral says the same.
TEST(EnvironmentLight, GivesTheIrradianceThatTheRendererBakes) {
  const FloatImage picture = gradient();
  const EnvironmentLight light(picture, 0.0f, 1.0f), turned(picture, 90.0f, 1.0f);
  Random random(9);
  for (int i = 0; i < 50; ++i) {
    const vec3 n = random.direction();
    const vec3 sampled = sampled_irradiance(light, n);
    EXPECT_LT(glm::length(sampled - (vec3(1.0f) + vec3(2.0f, 2.0f, 1.0f) / 3.0f * n)), 3e-3f);
    EXPECT_LT(glm::length(sampled - bake::irradiance(picture, n)), 3e-3f);
    EXPECT_LT(glm::length(sampled_irradiance(turned, {n.z, n.y, -n.x}) - sampled), 3e-3f);
  }
}

TEST(EnvironmentLight, SamplesMeetTheirDensity) {
  for (const float rotation : {0.0f, 35.0f}) {
    const EnvironmentLight light(rough_picture(), rotation, 1.0f);
    const auto sampler = [&](Random& random) { return std::optional(light.sample(uniform_2d(random)).wi); };
    const auto pdf_sr = [&](const vec3& d) { return light.pdf_sr(d); };
    EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, {.axis = {0, 1, 0}}, {.fineness = 48}), 4)) << rotation;
    const vec3 aside = glm::normalize(vec3(1.0f, 2.0f, -1.0f));
    EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, {.axis = aside}, {.fineness = 48}), 4)) << rotation;
  }
}

TEST(EnvironmentLight, SamplesKnowTheirRadianceAndDensity) {
  const EnvironmentLight light(rough_picture(), 123.0f, 0.7f);
  Random random(10);
  constexpr int kSamples = 100000;
  int other_pixel = 0;  // a direction on a pixel's edge may be read as the next one's
  for (int i = 0; i < kSamples; ++i) {
    const auto sample = light.sample(uniform_2d(random));
    ASSERT_NEAR(glm::length(sample.wi), 1.0f, 1e-6);
    ASSERT_LT(glm::length(light.radiance(sample.wi) - sample.radiance), 1e-4f);
    other_pixel += light.pdf_sr(sample.wi) != sample.pdf_sr ? 1 : 0;
  }
  EXPECT_LT(other_pixel, kSamples / 1000);
}

// Wherever there is light, it can be found, and no sample weighs too much. Around a lone light, bilinear reads fade
// over eight pixels: the farthest hold a quarter at a corner, 1 / 24 in the root of the mean square, so that the
// largest weight is 6 times the sum of all such roots, which is 0.583 + 4 x 0.156 + 4 x 0.042 = 1.37 lights.
TEST(EnvironmentLight, FindsAllLight) {
  const EnvironmentLight light(lone_lamp(), 20.0f, 1.0f);
  const double pixel_sr = (std::cos(5.0 * shading::kPiExact / 16.0) - std::cos(6.0 * shading::kPiExact / 16.0)) * 2.0 *
                          shading::kPiExact / 32.0;
  Random random(11);
  int lit = 0;
  for (int i = 0; i < 200000; ++i) {
    const vec3 d = random.direction();
    const float radiance = light.radiance(d).y;
    if (radiance <= 0.0f) continue;
    ++lit;
    ASSERT_GT(light.pdf_sr(d), 0.0f);
    // Neighbouring rows differ in solid angle by a tenth.
    ASSERT_LT(radiance / light.pdf_sr(d), 1.15 * 6.0 * 1.37 * 1000.0 * pixel_sr);
  }
  EXPECT_GT(lit, 500);
}

// The light of a lone light: its pixel's solid angle times radiance, since bilinear reading hands on but keeps the sum,
// where rows have nearly the same solid angle.
TEST(EnvironmentLight, KeepsThePowerOfASmallLamp) {
  const FloatImage picture = lone_lamp();
  const EnvironmentLight light(picture, 20.0f, 1.0f);
  glm::dvec3 sum(0.0);
  constexpr std::uint32_t kSamples = 1u << 16;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto sample = light.sample(shading::scrambled_sobol_2d(i, 2u));
    sum += glm::dvec3(sample.radiance / sample.pdf_sr) / double{kSamples};
  }
  const double rows = std::cos(5.0 * shading::kPiExact / 16.0) - std::cos(6.0 * shading::kPiExact / 16.0);
  EXPECT_NEAR(sum.x / (1000.0 * rows * 2.0 * shading::kPiExact / 32.0), 1.0, 0.01);
}

TEST(EnvironmentLight, ZerosAreDark) {
  const FloatImage black = make_picture(8, 4, [](const vec3&) { return vec3(0.0f); });
  const EnvironmentLight none(black, 0.0f, 1.0f), switched_off(rough_picture(), 0.0f, 0.0f);
  for (const EnvironmentLight* light : {&none, &switched_off}) {
    EXPECT_TRUE(light->dark());
    EXPECT_EQ(light->pdf_sr({0, 1, 0}), 0.0f);
    EXPECT_EQ(light->radiance({0, 1, 0}), vec3(0.0f));
  }
  EXPECT_FALSE(EnvironmentLight(lone_lamp(), 0.0f, 1.0f).dark());
}

TEST(EnvironmentLight, OnePixelIsAnEvenSphere) {
  const EnvironmentLight light(make_picture(1, 1, [](const vec3&) { return vec3(3.0f, 2.0f, 1.0f); }), 10.0f, 1.0f);
  Random random(12);
  for (int i = 0; i < 1000; ++i) {
    const auto sample = light.sample(uniform_2d(random));
    ASSERT_NEAR(sample.pdf_sr * 4.0 * shading::kPiExact, 1.0, 1e-5);
    ASSERT_NEAR(light.pdf_sr(random.direction()) * 4.0 * shading::kPiExact, 1.0, 1e-5);
    ASSERT_LT(glm::length(sample.radiance - vec3(3.0f, 2.0f, 1.0f)), 1e-5f);
  }
}

// As bright as a file can make it: no sum overflows.
TEST(EnvironmentLight, TheBrightestFloatsAreSampled) {
  const EnvironmentLight light(make_picture(8, 4, [](const vec3&) { return vec3(3e38f); }), 0.0f, 1.0f);
  EXPECT_NEAR(light.pdf_sr({0, 0, 1}) * 4.0 * shading::kPiExact, 1.0, 1e-5);
  EXPECT_NEAR(light.sample({0.3f, 0.6f}).pdf_sr * 4.0 * shading::kPiExact, 1.0, 1e-5);
}

}  // namespace
}  // namespace velarium::statistical
