#include "gpu_fixture.hpp"

#include "passes/display/display.hpp"
#include "passes/exposure/exposure.hpp"
#include "shading/host.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace velarium {
namespace {

using Rgba16 = std::array<std::uint16_t, 4>;

constexpr display::Settings kWords{.bits = 16, .dither = false};
constexpr display::Settings kBytes{.bits = 8, .dither = false};

class Display : public GpuTest {
 protected:
  struct Look {
    display::Settings settings = kWords;
    float stops = 0.0f;
    std::uint32_t frames = 1;
  };

  static std::vector<Rgba16> shown(std::uint32_t width, const std::vector<glm::vec4>& sum, const Look& look) {
    auto image = float_image(width, static_cast<std::uint32_t>(sum.size()) / width, sum);
    return run<Rgba16>([&](graph::Graph& graph) {
      const auto handle = graph.import("sum", image, true);
      const auto multiplier = exposure::add(graph, {handle, look.frames}, {.exposure = look.stops});
      return display::add(graph, {handle, multiplier.exposure, look.frames}, look.settings);
    });
  }

  static Rgba16 shown(glm::vec4 pixel, const Look& look) { return shown(1, {pixel}, look).front(); }
};

TEST_F(Display, MatchesTheCppReadingOfEveryCurve) {
  std::vector<glm::vec4> sum;
  for (int i = 0; i < 64; ++i) {
    const float x = std::exp2(-10.0f + 0.25f * static_cast<float>(i));
    sum.emplace_back(x, 0.6f * x, 0.05f + 0.2f * x, 1.0f);
  }
  for (std::uint32_t curve = 0; curve < 4; ++curve) {
    auto look = Look{.settings = kWords, .stops = -1.0f};
    look.settings.tonemap = static_cast<Tonemap>(curve);
    const auto values = shown(16, sum, look);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const auto expected = shading::srgb_encode(shading::tonemap(curve, 0.5f * glm::vec3(sum[i])));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(values[i][static_cast<std::size_t>(c)], 65535.0f * std::min(expected[c], 1.0f), 8.0f)
            << "curve " << curve << " pixel " << i << " channel " << c;  // 8: what pow and log2 of a GPU may differ by
      EXPECT_EQ(values[i][3], 65535);
    }
  }
}

TEST_F(Display, FramesAreAveraged) {
  const Look look{.settings = {.tonemap = Tonemap::linear, .bits = 16, .dither = false}, .frames = 4};
  const auto value = shown({4.0f, 2.0f, 0.0f, 4.0f}, look);
  EXPECT_EQ(value[0], 65535);
  // sRGB code of 0.5 [IEC 61966-2-1]: 0.735357.
  EXPECT_NEAR(value[1], 0.735357f * 65535.0f, 2.0f);
  EXPECT_EQ(value[2], 0);
  EXPECT_EQ(value[3], 65535);
}

TEST_F(Display, AlphaIsStraight) {
  const Look look{.settings = {.tonemap = Tonemap::linear, .bits = 8, .dither = false}};
  const auto half_covered = shown({0.25f, 0.5f, 0.0f, 0.5f}, look);
  const auto covered = shown({0.5f, 1.0f, 0.0f, 1.0f}, look);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(half_covered[c], covered[c]);
  EXPECT_EQ(half_covered[3] >> 8, 128);
  EXPECT_EQ(shown({1.0f, 1.0f, 1.0f, 0.0f}, look), (Rgba16{0, 0, 0, 0}));
}

TEST_F(Display, BrokenLightIsBlackAndEndlessLightIsWhite) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (std::uint32_t curve = 0; curve < 4; ++curve) {
    Look look{.settings = kWords};
    look.settings.tonemap = static_cast<Tonemap>(curve);
    const auto black = shown({0.0f, 0.0f, 0.0f, 1.0f}, look);
    EXPECT_EQ(shown({nan, nan, nan, 1.0f}, look), black) << curve;
    EXPECT_EQ(shown({-1.0f, -1e30f, -inf, 1.0f}, look), black) << curve;
    EXPECT_EQ(shown({1.0f, 1.0f, 1.0f, nan}, look)[3], 0) << curve;
    const auto white = shown({inf, inf, inf, 1.0f}, look);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_GT(white[c], 65000) << curve;
  }
}

TEST_F(Display, EightBitValuesAreWholeAndRight) {
  std::vector<glm::vec4> sum;
  for (int i = 0; i < 256; ++i)
    sum.emplace_back(glm::vec3(shading::srgb_decode_channel(static_cast<float>(i) / 255.0f)), 1.0f);
  for (const bool dither : {false, true}) {
    const auto values = shown(16, sum, {.settings = {.tonemap = Tonemap::linear, .bits = 8, .dither = dither}});
    for (int i = 0; i < 256; ++i) {
      const auto value = values[static_cast<std::size_t>(i)][1];
      EXPECT_EQ(value % 257, 0);
      if (dither)  // rounding errors of the encoding may be dithered into the next step
        EXPECT_LE(std::abs((value >> 8) - i), 1);
      else
        EXPECT_EQ(value >> 8, i);
    }
    EXPECT_EQ(values.front()[0], 0);
    EXPECT_EQ(values.back()[0], 65535);
  }
}

TEST_F(Display, DitherKeepsTheMean) {
  for (const float step : {100.25f, 30.5f, 200.9f}) {
    const float light = shading::srgb_decode_channel(step / 255.0f);
    const std::vector<glm::vec4> sum(128 * 128, glm::vec4(light, light, light, 1.0f));
    Look look{.settings = {.tonemap = Tonemap::linear, .bits = 8, .dither = true, .seed = 7}};
    double mean = 0.0;
    for (const auto& value : shown(128, sum, look)) {
      mean += value[0] >> 8;
      EXPECT_EQ(value[0], value[2]) << "greys stay grey";
      EXPECT_LE(std::fabs(static_cast<float>(value[0] >> 8) - step), 1.0f);
    }
    EXPECT_NEAR(mean / static_cast<double>(sum.size()), step, 0.01);
    look.settings.dither = false;
    EXPECT_EQ(shown(128, sum, look).front()[0] >> 8, std::lround(step));
  }
}

TEST_F(Display, SixteenBitsAreNeverDithered) {
  const std::vector<glm::vec4> sum(64, glm::vec4(0.2f, 0.2f, 0.2f, 1.0f));
  const auto values = shown(8, sum, {.settings = {.bits = 16, .dither = true}});
  for (const auto& value : values) EXPECT_EQ(value, values.front());
}

TEST_F(Display, ABackgroundLiesBehindTheCurve) {
  Look look{.settings = kBytes};
  look.settings.background = {1.0f, 0.5f, 0.0f};
  EXPECT_EQ(shown({0.0f, 0.0f, 0.0f, 0.0f}, look), (Rgba16{65535, 128 * 257, 0, 65535}));
  // Half of linear white over black: sRGB code of 0.5 is 187.5 steps.
  look.settings.background = {0.0f, 0.0f, 0.0f};
  look.settings.tonemap = Tonemap::linear;
  EXPECT_NEAR(shown({0.5f, 0.5f, 0.5f, 0.5f}, look)[0] >> 8, 188, 1);
}

TEST_F(Display, LinearReadbackIsTheMean) {
  auto image = float_image(2, 1, {{3.0f, 6.0f, -9.0f, 1.5f}, {1e6f, 0.0f, 3e-5f, 0.0f}});
  const auto values = run<glm::vec4>(
      [&](graph::Graph& graph) { return display::linear_readback(graph, graph.import("sum", image, true), 3); });
  ASSERT_EQ(values.size(), 2u);
  EXPECT_FLOAT_EQ(values[0].y, 2.0f);
  EXPECT_FLOAT_EQ(values[0].z, -3.0f);
  EXPECT_FLOAT_EQ(values[0].w, 0.5f);
  EXPECT_FLOAT_EQ(values[1].x, 1e6f / 3.0f);
  EXPECT_FLOAT_EQ(values[1].z, 1e-5f);
}

}  // namespace
}  // namespace velarium
