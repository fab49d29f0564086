// The shader is the C++: each shared function gives the same on the device as on the host.

#include "support/device_choice.hpp"

#include "gpu/gpu_context.hpp"
#include "shading/host.hpp"
#include "upload/transfer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace velarium {
namespace {

constexpr std::uint32_t kShader[] =
#include "shaders/parity/functions.comp.inc"
    ;

namespace io {
using namespace shading;
#include "functions_io.glsl"
}  // namespace io

constexpr std::uint32_t kSamples = 4096;

struct Row {
  std::uint32_t line;  // of functions.def
  const char* name;
  double ulps;
};

constexpr Row kRows[] = {
#define PARITY(name, ulps, expression) {__LINE__, #name, ulps},
#include "functions.def"
#undef PARITY
};

}  // namespace

namespace shading {

// GLSL's constructor syntax for structures.
#define GpuLight(...) \
  GpuLight {          \
    __VA_ARGS__       \
  }
vec4 evaluate_on_host(uint function, vec4 a, vec4 b, [[maybe_unused]] vec4 c) {
  switch (function) {
#define PARITY(name, ulps, expression) \
  case __LINE__:                       \
    return expression;
#include "functions.def"
#undef PARITY
    default:
      return vec4(0.0f);
  }
}
#undef GpuLight

}  // namespace shading

namespace {

std::vector<glm::vec4> random_inputs() {
  std::vector<glm::vec4> values;
  for (std::uint32_t i = 0; i < 3 * kSamples; ++i) {
    glm::vec4 v;
    for (std::uint32_t k = 0; k < 4; ++k) v[static_cast<int>(k)] = shading::hash_to_float(4 * i + k);
    values.push_back(v);
  }
  return values;
}

class Parity : public testing::TestWithParam<Row> {
 protected:
  static void SetUpTestSuite() {
    device_ = std::make_unique<gpu::Device>(test::device_choice(), true);
    tools_ = std::make_unique<gpu::GpuContext>(*device_);
    inputs_ = random_inputs();
  }
  static void TearDownTestSuite() {
    tools_.reset();
    device_.reset();
  }

  static std::vector<glm::vec4> run_on_device(std::uint32_t function) {
    const auto inputs = upload::make_buffer(*device_, inputs_, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const gpu::Buffer outputs(*device_, kSamples * sizeof(glm::vec4), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                              gpu::MemoryUse::readback);
    const auto& pipeline = tools_->pipelines.compute(kShader);
    tools_->descriptors.reset();
    const auto bindings = gpu::Bindings().buffer(io::Inputs, inputs).buffer(io::Outputs, outputs);
    const auto set = tools_->descriptors.make(pipeline, 0, bindings);
    const VkCommandBuffer commands = device_->begin();
    vkCmdBindPipeline(commands, pipeline.bind_point(), pipeline.vk());
    vkCmdBindDescriptorSets(commands, pipeline.bind_point(), pipeline.layout(), 0, 1, &set, 0, nullptr);
    const io::FunctionPush push{function, kSamples};
    vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(push), &push);
    vkCmdDispatch(commands, kSamples / 64, 1, 1);
    const VkMemoryBarrier2 barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                   .srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                   .srcAccessMask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                                   .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
                                   .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
    const VkDependencyInfo info{
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
    vkCmdPipelineBarrier2(commands, &info);
    device_->submit_and_wait(commands);
    const auto mapped = outputs.mapped_as<glm::vec4>().first(kSamples);
    return {mapped.begin(), mapped.end()};
  }

  static inline std::unique_ptr<gpu::Device> device_;
  static inline std::unique_ptr<gpu::GpuContext> tools_;
  static inline std::vector<glm::vec4> inputs_;
};

TEST_P(Parity, DeviceAgreesWithHost) {
  const Row row = GetParam();
  const auto device = run_on_device(row.line);
  double worst = 0;
  std::size_t worst_sample = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const auto host = shading::evaluate_on_host(row.line, inputs_[3 * i], inputs_[3 * i + 1], inputs_[3 * i + 2]);
    for (int k = 0; k < 4; ++k) {
      ASSERT_TRUE(std::isfinite(host[k]) && std::isfinite(device[i][k])) << "sample " << i;
      const double scale = std::max(std::abs(static_cast<double>(host[k])), 1.0);
      const double ulps = std::abs(static_cast<double>(host[k]) - static_cast<double>(device[i][k])) /
                          (scale * static_cast<double>(std::numeric_limits<float>::epsilon()));
      if (ulps <= worst) continue;
      worst = ulps;
      worst_sample = i;
    }
  }
  RecordProperty("worst_ulps", std::to_string(worst));
  EXPECT_LE(worst, row.ulps) << "at sample " << worst_sample;
}

INSTANTIATE_TEST_SUITE_P(SharedFunctions, Parity, testing::ValuesIn(kRows),
                         [](const auto& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace velarium
