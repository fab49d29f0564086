#include "gpu_fixture.hpp"

#include "passes/accumulate/accumulate.hpp"
#include "passes/display/display.hpp"

#include <cstring>

namespace velarium {
namespace {

class Accumulate : public GpuTest {
 protected:
  static constexpr std::uint32_t kWidth = 13, kHeight = 9;  // no multiples of a group's size

  static std::vector<glm::vec4> frame(float level) {
    std::vector<glm::vec4> pixels;
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
      const float x = level * static_cast<float>(i + 1) / 37.0f;
      pixels.emplace_back(x, 2.0f * x, 0.1f * x, 0.5f);
    }
    return pixels;
  }

  // The mean of the frames, each added by a graph of its own, as the engine does.
  static std::vector<glm::vec4> mean(const std::vector<std::vector<glm::vec4>>& frames) {
    gpu::Image sum(tools().device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .width = kWidth, .height = kHeight},
                   VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    std::vector<glm::vec4> result;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      auto hdr = half_image(kWidth, kHeight, frames[i]);
      result = run<glm::vec4>([&](graph::Graph& graph) {
        const auto total = accumulate::add(
            graph, {.hdr = graph.import("hdr", hdr, true), .sum = graph.import("sum", sum, i != 0), .first = i == 0});
        return display::linear_readback(graph, total, static_cast<std::uint32_t>(i + 1));
      });
    }
    return result;
  }
};

TEST_F(Accumulate, TheFirstFrameReplacesTheSum) {
  const auto pixels = frame(1.0f);
  const auto result = mean({pixels});
  ASSERT_EQ(result.size(), pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    EXPECT_EQ(result[i], glm::unpackHalf4x16(glm::packHalf4x16(pixels[i]))) << i;
}

TEST_F(Accumulate, TheMeanIsThatOfTheFrames) {
  const auto result = mean({frame(1.0f), frame(2.0f), frame(6.0f)});
  const auto expected = frame(3.0f);
  for (std::size_t i = 0; i < expected.size(); ++i)
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(result[i][c], expected[i][c], 1e-3f * expected[i][c]) << i;  // halves
}

TEST_F(Accumulate, EqualFramesGiveEqualBytes) {
  const std::vector<std::vector<glm::vec4>> frames{frame(0.3f), frame(1.7f), frame(0.9f)};
  const auto first = mean(frames), second = mean(frames);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(glm::vec4)), 0);
}

}  // namespace
}  // namespace velarium
