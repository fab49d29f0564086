// Volumes and chains of mips on a device: the validation layers hold the barriers and views to the rules.

#include "display/gpu_fixture.hpp"

namespace velarium::graph {
namespace {

// What the shaders bind.
using gpu::SlotType;
constexpr gpu::Slot kFilled{0, 0, SlotType::storage_image};
constexpr gpu::Slot kFiner{0, 0, SlotType::texture3D}, kCoarser{0, 1, SlotType::storage_image}, kReadSlot{0, 1};

constexpr std::uint32_t kFill[] =
#include "shaders/graph/device/volume_fill.comp.inc"
    ;
constexpr std::uint32_t kHalve[] =
#include "shaders/graph/device/volume_halve.comp.inc"
    ;
constexpr std::uint32_t kRead[] =
#include "shaders/graph/device/volume_read.comp.inc"
    ;

constexpr VkExtent3D kGroup{4, 4, 4};
// No multiples of a group's size, and no powers of two.
constexpr gpu::ImageDesc kVolume{.format = VK_FORMAT_R32_UINT, .width = 11, .height = 6, .depth = 5, .mips = 4};

std::uint32_t texels(const gpu::ImageDesc& desc, std::uint32_t mip) {
  const VkExtent3D size = gpu::mip_extent(desc, mip);
  return size.width * size.height * size.depth;
}

std::uint32_t texels(const gpu::ImageDesc& desc) {
  std::uint32_t sum = 0;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) sum += texels(desc, mip);
  return sum;
}

GraphImage add_fill(Graph& graph, GraphImage volume, std::uint32_t number) {
  auto& pass = graph.pass("fill");
  const auto filled = pass.write(volume.at(0), Access::compute_storage);
  pass.run([=](Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kFill);
    c.bind(pipeline);
    c.set(pipeline, 0).storage(kFilled, filled).bind();
    c.push(pipeline, number);
    c.dispatch(gpu::mip_extent(c.image(filled).desc(), 0), kGroup);
  });
  return filled.whole();
}

GraphImage add_halve(Graph& graph, GraphImage volume, std::uint32_t mip) {
  auto& pass = graph.pass("halve");
  const auto finer = volume.at(mip - 1);
  pass.read(finer, Access::compute_sample);
  const auto coarser = pass.write(volume.at(mip), Access::compute_storage);
  pass.run([=](Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kHalve);
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(kFiner, finer).storage(kCoarser, coarser).bind();
    c.dispatch(gpu::mip_extent(c.image(coarser).desc(), coarser.mip), kGroup);
  });
  return coarser.whole();
}

GraphImage add_chain(Graph& graph, GraphImage volume, std::uint32_t number) {
  volume = add_fill(graph, volume, number);
  for (std::uint32_t mip = 1; mip < graph.desc(volume).mips; ++mip) volume = add_halve(graph, volume, mip);
  return volume;
}

GraphBuffer add_read(Graph& graph, GraphImage volume) {
  auto& pass = graph.pass("read");
  pass.read(volume, Access::compute_sample);
  const auto values =
      pass.write(graph.buffer("values", texels(graph.desc(volume)) * sizeof(std::uint32_t), gpu::MemoryUse::readback),
                 Access::compute_storage);
  pass.run([=](Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kRead);
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(kFiner, volume).buffer(kReadSlot, values).bind();
    c.dispatch(gpu::mip_extent(c.image(volume).desc(), 0), kGroup);
  });
  graph.pass("hand over").read(values, Access::host_read);
  return values;
}

// What the shaders must make, by plain loops.
std::vector<std::uint32_t> expected_chain(const gpu::ImageDesc& desc, std::uint32_t number) {
  std::vector<std::uint32_t> all, finer;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) {
    const VkExtent3D size = gpu::mip_extent(desc, mip), from = gpu::mip_extent(desc, mip == 0 ? 0 : mip - 1);
    std::vector<std::uint32_t> values;
    for (std::uint32_t z = 0; z < size.depth; ++z)
      for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x) {
          std::uint32_t sum = mip == 0 ? x + 16 * y + 256 * z + number : 0;
          for (std::uint32_t i = 0; mip > 0 && i < 8; ++i) {
            const std::uint32_t u = std::min(2 * x + (i & 1), from.width - 1),
                                v = std::min(2 * y + (i >> 1 & 1), from.height - 1),
                                w = std::min(2 * z + (i >> 2), from.depth - 1);
            sum += finer[u + from.width * (v + from.height * w)];
          }
          values.push_back(sum);
        }
    all.insert(all.end(), values.begin(), values.end());
    finer = values;
  }
  return all;
}

class GraphImages : public GpuTest {
 protected:
  static std::vector<std::uint32_t> values(const Executor& executor, GraphBuffer handle, std::uint32_t count) {
    const auto mapped = executor.buffer(handle).mapped_as<std::uint32_t>().first(count);
    return {mapped.begin(), mapped.end()};
  }
  static gpu::Image make_volume() {
    return {tools().device, kVolume, VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
  }
};

TEST_F(GraphImages, EachMipOfAVolumeIsMadeOfTheOneBefore) {
  Executor executor(tools());
  for (const std::uint32_t number : {3u, 70u}) {  // twice: what the first frame leaves must not disturb the second
    Graph graph;
    const auto out = add_read(graph, add_chain(graph, graph.image("volume", kVolume), number));
    executor.run(graph);
    EXPECT_EQ(values(executor, out, texels(kVolume)), expected_chain(kVolume, number));
  }
}

TEST_F(GraphImages, AnImportedChainIsReadableInTheNextGraph) {
  auto volume = make_volume();
  Executor executor(tools());
  {
    Graph graph;  // leaves the last mip stored to, all others sampled
    static_cast<void>(add_chain(graph, graph.import("volume", volume, false), 5));
    executor.run(graph);
  }
  EXPECT_EQ(volume.layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  Graph graph;
  const auto out = add_read(graph, graph.import("volume", volume, true));
  executor.run(graph);
  EXPECT_EQ(values(executor, out, texels(kVolume)), expected_chain(kVolume, 5));
}

TEST_F(GraphImages, AMipThatIsMadeAgainChangesNoOther) {
  auto volume = make_volume();
  Executor executor(tools());
  Graph first;
  static_cast<void>(add_chain(first, first.import("volume", volume, false), 5));
  executor.run(first);
  Graph second;
  const auto out = add_read(second, add_fill(second, second.import("volume", volume, true), 900));
  executor.run(second);
  auto expected = expected_chain(kVolume, 5);
  const auto filled = expected_chain(kVolume, 900);
  std::copy_n(filled.begin(), texels(kVolume, 0), expected.begin());
  EXPECT_EQ(values(executor, out, texels(kVolume)), expected);
}

TEST_F(GraphImages, OneMipIsDrawnTo) {
  constexpr gpu::ImageDesc kFlat{.format = VK_FORMAT_R32_SFLOAT, .width = 9, .height = 7, .mips = 3};
  constexpr VkExtent3D kSize{4, 3, 1};  // of mip 1
  Executor executor(tools());
  Graph graph;
  auto& draw = graph.pass("draw");
  const auto drawn = draw.write(graph.image("color", kFlat).at(1), Access::color_attachment);
  draw.run([=](Context& c) {
    c.begin_rendering({.colors = {{drawn, true}}});
    c.clear_color({0, 0, kSize.width, kSize.height}, {0.25f, 0.0f, 0.0f, 0.0f});
    c.end_rendering();
  });
  auto& copy = graph.pass("copy");
  copy.read(drawn, Access::transfer_read);
  constexpr std::uint32_t kCount = kSize.width * kSize.height;
  const auto out =
      copy.write(graph.buffer("texels", kCount * sizeof(float), gpu::MemoryUse::readback), Access::transfer_write);
  copy.run([=](Context& c) {
    const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, drawn.mip, 0, 1},
                                   .imageExtent = kSize};
    vkCmdCopyImageToBuffer(c.commands(), c.image(drawn).vk(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, c.buffer(out).vk(),
                           1, &region);
  });
  graph.pass("hand over").read(out, Access::host_read);
  executor.run(graph);
  for (const float texel : executor.buffer(out).mapped_as<float>().first(kCount)) EXPECT_EQ(texel, 0.25f);
}

TEST_F(GraphImages, ViewsOfEveryKindAreValid) {
  constexpr VkImageUsageFlags kShader = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                              kColor = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                              kDepth = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  constexpr VkFormat kHalf = VK_FORMAT_R16G16B16A16_SFLOAT;
  auto& device = tools().device;
  const gpu::Image cube(device, {.format = kHalf, .width = 8, .height = 8, .layers = 6, .mips = 4, .cube = true},
                        kShader | kColor);
  const gpu::Image array(device, {.format = kHalf, .width = 8, .height = 4, .layers = 3, .mips = 3}, kShader | kColor);
  const gpu::Image depth(device, {.format = VK_FORMAT_D32_SFLOAT_S8_UINT, .width = 8, .height = 8, .mips = 2}, kDepth);
  const gpu::Image flat(device, {.format = kHalf, .width = 8, .height = 8}, kShader | kColor);
  EXPECT_NO_THROW(device.refuse_validation_messages());
  EXPECT_NE(cube.layer_view(5, 3), cube.layer_view(5, 2));
  EXPECT_NE(cube.sampled_view(3), cube.mip_view(3)) << "one samples a cube, the other is an array";
  EXPECT_NE(array.layer_view(2, 1), array.layer_view(1, 1));
  EXPECT_EQ(depth.sampled_view(), depth.depth_view());
  EXPECT_NE(depth.sampled_view(1), depth.layer_view(0, 1));
  EXPECT_EQ(flat.sampled_view(0), flat.view());
  EXPECT_EQ(flat.layer_view(0), flat.view());
}

TEST(ImageDesc, MipsOfAVolumeHalveAlongEachAxis) {
  const auto third = gpu::mip_extent(kVolume, 2);
  EXPECT_EQ(third.width, 2u);
  EXPECT_EQ(third.height, 1u);
  EXPECT_EQ(third.depth, 1u);
  EXPECT_EQ(gpu::full_mip_count(4, 4, 16), 5u);
}

}  // namespace
}  // namespace velarium::graph
