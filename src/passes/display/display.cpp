#include "passes/display/display.hpp"

#include "core/assert.hpp"
#include "passes/io.hpp"

namespace velarium::display {
namespace {

namespace io {
using namespace shading;
#include "passes/display/display_io.glsl"
}  // namespace io
namespace average {
using namespace shading;
#include "passes/display/average_io.glsl"
}  // namespace average

using graph::Access;

constexpr std::uint32_t kDisplayShader[] =
#include "shaders/passes/display/display.comp.inc"
    ;
constexpr std::uint32_t kAverageShader[] =
#include "shaders/passes/display/average.comp.inc"
    ;

static_assert(static_cast<std::uint32_t>(Tonemap::neutral) == shading::kTonemapNeutral);
static_assert(static_cast<std::uint32_t>(Tonemap::agx) == shading::kTonemapAgx);
static_assert(static_cast<std::uint32_t>(Tonemap::aces) == shading::kTonemapAces);
static_assert(static_cast<std::uint32_t>(Tonemap::linear) == shading::kTonemapLinear);

io::DisplayPush push_of(const Inputs& in, const Settings& settings) {
  io::DisplayPush push{.frame_weight = 1.0f / static_cast<float>(in.frame_count), .seed = settings.seed};
  if (settings.background) {
    const auto& encoded = *settings.background;
    const auto linear = shading::srgb_decode({encoded[0], encoded[1], encoded[2]});
    push.background = {linear.x, linear.y, linear.z, 1.0f};
  }
  return push;
}

// Through an image and not a storage buffer, whose binding may be limited to 128 MiB: fewer than 17 million pixels.
graph::GraphBuffer read_back(graph::Graph& graph, const char* pass_name, graph::GraphImage image,
                             std::uint32_t texel_bytes) {
  const gpu::ImageDesc& desc = graph.desc(image);
  const VkExtent3D extent{desc.width, desc.height, 1};
  const VkDeviceSize bytes = VkDeviceSize{texel_bytes} * desc.width * desc.height;
  auto& copy = graph.pass(pass_name);
  copy.read(image, Access::transfer_read);
  const auto buffer = copy.write(graph.buffer("pixels", bytes, gpu::MemoryUse::readback), Access::transfer_write);
  copy.run([=](graph::Context& c) {
    const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1}, .imageExtent = extent};
    vkCmdCopyImageToBuffer(c.commands(), c.image(image).vk(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           c.buffer(buffer).vk(), 1, &region);
  });
  graph.pass(std::string(pass_name) + "_to_host").read(buffer, Access::host_read);
  return buffer;
}

}  // namespace

graph::GraphBuffer add(graph::Graph& graph, const Inputs& in, const Settings& settings) {
  VEL_ASSERT(settings.bits == 8 || settings.bits == 16);
  auto desc = graph.desc(in.sum);
  desc.format = VK_FORMAT_R16G16B16A16_UINT;
  gpu::Specialization constants;
  constants.set(io::kTonemap, static_cast<std::uint32_t>(settings.tonemap))
      .set(io::kBits, static_cast<std::uint32_t>(settings.bits))
      .set(io::kDither, settings.dither);
  const io::DisplayPush push = push_of(in, settings);

  auto& pass = graph.pass("display");
  pass.read(in.sum, Access::compute_sample).read(in.exposure, Access::compute_sample);
  const auto values = pass.write(graph.image("values", desc), Access::compute_storage);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kDisplayShader, constants);
    c.bind(pipeline);
    c.set(pipeline, 0)
        .sampled(io::frame_sum, in.sum)
        .buffer(io::Exposure, in.exposure)
        .storage(io::values, values)
        .bind();
    c.push(pipeline, push);
    c.dispatch(desc.width, desc.height, 8, 8);
  });
  return read_back(graph, "display_copy", values, 4 * sizeof(std::uint16_t));
}

graph::GraphBuffer linear_readback(graph::Graph& graph, graph::GraphImage sum, std::uint32_t frame_count) {
  const auto desc = graph.desc(sum);
  auto& pass = graph.pass("average");
  pass.read(sum, Access::compute_sample);
  const auto mean = pass.write(graph.image("mean", desc), Access::compute_storage);
  const average::AveragePush push{1.0f / static_cast<float>(frame_count)};
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kAverageShader);
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(average::frame_sum, sum).storage(average::mean, mean).bind();
    c.push(pipeline, push);
    c.dispatch(desc.width, desc.height, 8, 8);
  });
  return read_back(graph, "average_copy", mean, 4 * sizeof(float));
}

}  // namespace velarium::display
