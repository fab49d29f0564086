#include "gpu_fixture.hpp"

#include "passes/exposure/exposure.hpp"

#include <cmath>
#include <limits>

namespace velarium {
namespace {

constexpr float kKey = 0.18f;  // middle grey, which the mean is brought to

class Exposure : public GpuTest {
 protected:
  static constexpr std::uint32_t kWidth = 67, kHeight = 41;

  static std::vector<glm::vec4> uniform(glm::vec4 value) { return std::vector<glm::vec4>(kWidth * kHeight, value); }

  static float multiplier(const std::vector<glm::vec4>& sum, const Settings::display_settings& settings,
                          std::uint32_t frames = 1) {
    auto image = float_image(kWidth, kHeight, sum);
    return run<float>([&](graph::Graph& graph) {
             const auto out = exposure::add(graph, {graph.import("sum", image, true), frames}, settings);
             auto& copy = graph.pass("copy");
             copy.read(out.exposure, graph::Access::transfer_read);
             const auto host = copy.write(graph.buffer("host", sizeof(float), gpu::MemoryUse::readback),
                                          graph::Access::transfer_write);
             copy.run([=](graph::Context& c) {
               const VkBufferCopy region{.size = sizeof(float)};
               vkCmdCopyBuffer(c.commands(), c.buffer(out.exposure).vk(), c.buffer(host).vk(), 1, &region);
             });
             graph.pass("to_host").read(host, graph::Access::host_read);
             return host;
           })
        .front();
  }

  static constexpr Settings::display_settings automatic() { return {.exposure_mode = ExposureMode::automatic}; }
};

TEST_F(Exposure, ManualIsAPowerOfTwo) {
  EXPECT_FLOAT_EQ(multiplier(uniform(glm::vec4(9.0f)), {.exposure = 1.5f}), std::exp2(1.5f));
}

TEST_F(Exposure, Ev100FollowsTheSaturationSpeed) {
  // ISO 12232: 1 / (1.2 x 2^EV); one stop more doubles.
  const Settings::display_settings settings{.exposure_mode = ExposureMode::ev100, .exposure = 1.0f, .ev100 = 3.0f};
  EXPECT_FLOAT_EQ(exposure::manual_exposure(settings), 2.0f / (1.2f * 8.0f));
  EXPECT_FLOAT_EQ(multiplier(uniform(glm::vec4(1.0f)), settings), 2.0f / (1.2f * 8.0f));
}

TEST_F(Exposure, AutomaticBringsAUniformPictureToMiddleGrey) {
  for (const float level : {0.001f, 0.18f, 40.0f})
    EXPECT_NEAR(multiplier(uniform({level, level, level, 1.0f}), automatic()) * level, kKey, 1e-5f);
}

TEST_F(Exposure, AutomaticTakesTheGeometricMean) {
  auto sum = uniform({1.0f, 1.0f, 1.0f, 1.0f});
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = glm::vec4(glm::vec3(i % 2 == 0 ? 0.25f : 4.0f), 1.0f);
  sum.back() = glm::vec4(0.0f);  // an even number of pixels counts
  EXPECT_NEAR(multiplier(sum, automatic()), kKey, 1e-5f);
}

TEST_F(Exposure, AutomaticDividesByFramesAndCoverage) {
  // Two frames, a quarter covered, by light of 2.
  EXPECT_NEAR(multiplier(uniform({1.0f, 1.0f, 1.0f, 0.5f}), automatic(), 2), kKey / 2.0f, 1e-6f);
}

TEST_F(Exposure, AutomaticWeighsByCoverage) {
  auto sum = uniform({1.0f, 1.0f, 1.0f, 1.0f});
  sum.back() = glm::vec4(0.0f);
  for (std::size_t i = 0; i + 1 < sum.size(); i += 2) sum[i] = glm::vec4(0.25f * glm::vec3(16.0f), 0.25f);
  // Weights 1/4 at 4 stops and 1 at none: 0.8 stops.
  EXPECT_NEAR(multiplier(sum, automatic()), kKey / std::exp2(0.8f), 1e-5f);
}

TEST_F(Exposure, AutomaticIgnoresBlackAndBrokenPixels) {
  auto sum = uniform({2.0f, 2.0f, 2.0f, 1.0f});
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < 40; ++i) sum[i] = {0.0f, 0.0f, 0.0f, 1.0f};
  sum[100] = {nan, nan, nan, 1.0f};
  sum[200] = {inf, inf, inf, 1.0f};
  sum[300] = {1.0f, 1.0f, 1.0f, nan};
  sum[400] = {5.0f, 5.0f, 5.0f, 0.0f};
  EXPECT_NEAR(multiplier(sum, automatic()), kKey / 2.0f, 1e-6f);
}

TEST_F(Exposure, AutomaticLeavesABlackPictureAlone) {
  auto settings = automatic();
  settings.exposure = 2.0f;
  EXPECT_EQ(multiplier(uniform({0.0f, 0.0f, 0.0f, 1.0f}), settings), 4.0f);
}

TEST_F(Exposure, StopsAddToAutomatic) {
  auto settings = automatic();
  settings.exposure = -1.0f;
  EXPECT_NEAR(multiplier(uniform({1.0f, 1.0f, 1.0f, 1.0f}), settings), 0.5f * kKey, 1e-6f);
}

TEST_F(Exposure, AutomaticGivesEqualBitsOnEveryRun) {
  std::vector<glm::vec4> sum;
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i)
    sum.emplace_back(glm::vec3(0.01f + static_cast<float>(i * 2654435761u % 1000u)), 1.0f);
  const float first = multiplier(sum, automatic());
  for (int run = 0; run < 3; ++run) EXPECT_EQ(multiplier(sum, automatic()), first);
}

}  // namespace
}  // namespace velarium
