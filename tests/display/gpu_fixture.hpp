#pragma once

// One validated device for all tests of the program, and pictures in and out of it.

#include "support/device_choice.hpp"

#include "gpu/gpu_context.hpp"
#include "graph/context.hpp"
#include "graph/executor.hpp"
#include "upload/transfer.hpp"

#include <glm/gtc/packing.hpp>
#include <glm/vec4.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <span>
#include <vector>

namespace velarium {

class GpuTest : public ::testing::Test {
 protected:
  static gpu::GpuContext& tools() {
    static gpu::Device device(test::device_choice(), true);
    static gpu::GpuContext toolbox(device);
    return toolbox;
  }

  static gpu::Image upload(VkFormat format, std::uint32_t width, std::uint32_t height,
                           std::span<const std::byte> texels) {
    const upload::ImageSource source{{.format = format, .width = width, .height = height}, texels};
    return std::move(upload::make_images(tools().device, {&source, 1}).front());
  }

  static gpu::Image float_image(std::uint32_t width, std::uint32_t height, const std::vector<glm::vec4>& pixels) {
    return upload(VK_FORMAT_R32G32B32A32_SFLOAT, width, height, std::as_bytes(std::span(pixels)));
  }

  static gpu::Image half_image(std::uint32_t width, std::uint32_t height, const std::vector<glm::vec4>& pixels) {
    std::vector<std::uint64_t> halves;
    for (const auto& pixel : pixels) halves.push_back(glm::packHalf4x16(pixel));
    return upload(VK_FORMAT_R16G16B16A16_SFLOAT, width, height, std::as_bytes(std::span(halves)));
  }

  // Runs the graph that `describe` declares and returns the contents of the buffer that it returns.
  template <class T>
  static std::vector<T> run(const std::function<graph::GraphBuffer(graph::Graph&)>& describe) {
    graph::Graph graph;
    const auto buffer = describe(graph);
    graph::Executor executor(tools());
    executor.run(graph);
    const auto values = executor.buffer(buffer).mapped_as<T>();
    return {values.begin(), values.end()};
  }
};

}  // namespace velarium
