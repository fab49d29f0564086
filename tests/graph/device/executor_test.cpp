// What an executor keeps from graph to graph, and graphs that run while the next is recorded.

#include "display/gpu_fixture.hpp"

#include <algorithm>

namespace velarium::graph {
namespace {

// What the shaders bind.
using gpu::SlotType;
constexpr gpu::Slot kTexture{0, 0, SlotType::utexture2D}, kImage{0, 1, SlotType::storage_image}, kValueSlot{0, 2};
constexpr gpu::Slot kSums{0, 0}, kCopies{0, 1};

constexpr std::uint32_t kCountUp[] =
#include "shaders/graph/device/count_up.comp.inc"
    ;
constexpr std::uint32_t kAddUp[] =
#include "shaders/graph/device/add_up.comp.inc"
    ;

constexpr gpu::ImageDesc kCount{.format = VK_FORMAT_R32_UINT, .width = 5, .height = 3};
constexpr std::uint32_t kValues = 1000;

GraphBuffer handed_over(Graph& graph, GraphBuffer buffer) {
  graph.pass("hand over").read(buffer, Access::host_read);
  return buffer;
}

GraphBuffer readback(Graph& graph, Pass& pass, std::uint32_t count, Access access) {
  return pass.write(graph.buffer("values", count * sizeof(std::uint32_t), gpu::MemoryUse::readback), access);
}

// The image of the frame before plus a number.
GraphBuffer add_count(Graph& graph, std::uint32_t number, const gpu::ImageDesc& desc = kCount) {
  const auto count = graph.history("count", desc);
  auto& pass = graph.pass("count");
  pass.read(count.previous, Access::compute_sample);
  const auto next = pass.write(count.current, Access::compute_storage);
  const auto values = readback(graph, pass, desc.width * desc.height, Access::compute_storage);
  pass.run([=](Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kCountUp);
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(kTexture, count.previous).storage(kImage, next).buffer(kValueSlot, values).bind();
    c.push(pipeline, number);
    c.dispatch(desc.width, desc.height, 8, 8);
  });
  return handed_over(graph, values);
}

// Adds a number to a buffer, and copies it.
GraphBuffer add_sum(Graph& graph, GraphBuffer sums, std::uint32_t number) {
  auto& pass = graph.pass("sum");
  pass.read(sums, Access::compute_storage);
  const auto summed = pass.write(sums, Access::compute_storage);
  const auto values = readback(graph, pass, kValues, Access::compute_storage);
  pass.run([=](Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kAddUp);
    c.bind(pipeline);
    c.set(pipeline, 0).buffer(kSums, summed).buffer(kCopies, values).bind();
    c.push(pipeline, number);
    c.dispatch(kValues, 1, 64, 1);
  });
  return handed_over(graph, values);
}

// An image that nobody reads, cleared.
GraphImage add_clear(Graph& graph, std::string_view pass_name) {
  auto& pass = graph.pass(pass_name);
  const auto image = pass.write(graph.image("image", kCount), Access::color_attachment);
  pass.run([=](Context& c) {
    c.begin_rendering({.colors = {{image, true}}});
    c.end_rendering();
  });
  return image;
}

class GraphExecutor : public GpuTest {
 protected:
  // Expects every value to be this one.
  static void expect_all(const gpu::Buffer& buffer, std::uint32_t count, std::uint32_t value) {
    const auto values = buffer.mapped_as<std::uint32_t>().first(count);
    EXPECT_TRUE(std::all_of(values.begin(), values.end(), [=](std::uint32_t v) { return v == value; }))
        << values.front() << " instead of " << value;
  }
  static void expect_count(Executor& executor, std::uint32_t number, std::uint32_t value,
                           const gpu::ImageDesc& desc = kCount) {
    Graph graph(executor.history());
    const auto out = add_count(graph, number, desc);
    executor.run(graph);
    expect_all(executor.buffer(out), desc.width * desc.height, value);
  }
  static gpu::Buffer zeros() {
    gpu::Buffer buffer(tools().device, kValues * sizeof(std::uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                       gpu::MemoryUse::upload);
    std::ranges::fill(buffer.mapped(), std::byte{0});
    return buffer;
  }
  // Names of kept images, those of the last graph marked.
  static std::vector<std::string> kept(const Executor& executor) {
    std::vector<std::string> names;
    for (const auto& image : executor.images()) {
      EXPECT_GT(image.bytes, 0u) << image.name;
      names.push_back(image.name + (image.declared ? "*" : ""));
    }
    return names;
  }
};

using Names = std::vector<std::string>;

TEST_F(GraphExecutor, HistoryIsTheFrameBefore) {
  Executor executor(tools());
  expect_count(executor, 7, 7);  // of no frame before, zero is read
  expect_count(executor, 1, 8);
  expect_count(executor, 100, 108);
  executor.forget_history();
  expect_count(executor, 2, 2);
  expect_count(executor, 2, 4);
}

TEST_F(GraphExecutor, HistoryOfAnotherSizeBeginsAnew) {
  constexpr gpu::ImageDesc kLarger{.format = VK_FORMAT_R32_UINT, .width = 9, .height = 4};
  Executor executor(tools());
  expect_count(executor, 1, 1);
  expect_count(executor, 1, 2);
  expect_count(executor, 1, 1, kLarger);
  expect_count(executor, 1, 2, kLarger);
  expect_count(executor, 1, 1);
}

TEST_F(GraphExecutor, HistoryIsFoundAsWhatTheLastFrameWrote) {
  Executor executor(tools());
  Graph graph(executor.history());
  static_cast<void>(add_count(graph, 1));
  const auto* written = graph.images()[1].imported;
  executor.run(graph);
  EXPECT_EQ(executor.find_image("count"), written);
  EXPECT_EQ(kept(executor), (Names{"count*", "count.previous*"}));
}

TEST_F(GraphExecutor, HistoryOfDepthBeginsAtZero) {
  constexpr gpu::ImageDesc kDepth{.format = VK_FORMAT_D32_SFLOAT_S8_UINT, .width = 4, .height = 4};
  Executor executor(tools());
  Graph graph(executor.history());
  const auto depth = graph.history("depth", kDepth);
  auto& draw = graph.pass("draw");
  const auto drawn = draw.write(depth.current, Access::depth_attachment);
  draw.run([=](Context& c) {
    c.begin_rendering({.depth = drawn, .clear_depth = true});
    c.end_rendering();
  });
  auto& copy = graph.pass("copy");
  copy.read(depth.previous, Access::transfer_read);
  const auto out = readback(graph, copy, 16, Access::transfer_write);
  copy.run([=](Context& c) {
    const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, 1}, .imageExtent = {4, 4, 1}};
    vkCmdCopyImageToBuffer(c.commands(), c.image(depth.previous).vk(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           c.buffer(out).vk(), 1, &region);
  });
  handed_over(graph, out);
  executor.run(graph);
  expect_all(executor.buffer(out), 16, 0);
}

TEST_F(GraphExecutor, AnImportedBufferKeepsItsContents) {
  auto sums = zeros();
  Executor executor(tools());
  for (std::uint32_t i = 1; i <= 3; ++i) {
    Graph graph;
    const auto out = add_sum(graph, graph.import("sums", sums, true), i);
    executor.run(graph);
    expect_all(executor.buffer(out), kValues, i * (i + 1) / 2);
  }
}

TEST_F(GraphExecutor, AGraphIsRecordedWhileTheOneBeforeRuns) {
  constexpr std::uint32_t kFrames = 25;
  auto sums = zeros();
  Executor executor(tools());
  gpu::Submission before{};
  GraphBuffer out;
  for (std::uint32_t i = 1; i <= kFrames; ++i) {
    Graph graph(executor.history());
    static_cast<void>(add_clear(graph, "clear"));
    static_cast<void>(add_count(graph, 1));
    out = add_sum(graph, graph.import("sums", sums, true), i);
    const auto submission = executor.submit(graph);
    EXPECT_GT(submission, before);
    if (i > 1) {
      executor.wait(before);
      expect_all(executor.buffer(out, before), kValues, (i - 1) * i / 2);
      EXPECT_EQ(executor.timings(before).size(), tools().device.caps().timestamp_ns > 0.0 ? graph.passes().size() : 0);
    }
    before = submission;
  }
  executor.wait();
  expect_all(executor.buffer(out), kValues, kFrames * (kFrames + 1) / 2);
  expect_count(executor, 0, kFrames);
}

TEST_F(GraphExecutor, GraphsThatRunAtOnceHaveHostBuffersOfTheirOwn) {
  auto sums = zeros();
  Executor executor(tools());
  const auto submit = [&](GraphBuffer& out) {
    Graph graph;
    out = add_sum(graph, graph.import("sums", sums, true), 1);
    return executor.submit(graph);
  };
  GraphBuffer out;
  const auto first = submit(out), second = submit(out);
  EXPECT_NE(executor.buffer(out, first).vk(), executor.buffer(out, second).vk());
  executor.wait();
  expect_all(executor.buffer(out, first), kValues, 1);
  expect_all(executor.buffer(out, second), kValues, 2);
  const auto third = submit(out);
  executor.wait();
  const auto* reused = &executor.buffer(out, third);
  static_cast<void>(submit(out));
  executor.wait();
  EXPECT_EQ(&executor.buffer(out), reused) << "what does not overlap shares one";
}

TEST_F(GraphExecutor, MayBeGivenUpWhileAGraphRuns) {
  auto sums = zeros();
  Executor executor(tools());
  for (std::uint32_t i = 0; i < 6; ++i) {  // more than run at once, and than those that wait for new buffers
    Graph graph;
    static_cast<void>(add_sum(graph, graph.import("sums", sums, true), i));
    executor.submit(graph);
  }
  EXPECT_NO_THROW(tools().device.refuse_validation_messages());
}

TEST_F(GraphExecutor, MakesLargerImagesWhileAGraphRuns) {
  Executor executor(tools());
  for (std::uint32_t i = 1; i <= 4; ++i) {
    Graph graph(executor.history());
    static_cast<void>(add_count(graph, i, {.format = VK_FORMAT_R32_UINT, .width = 64 * i, .height = 64}));
    executor.submit(graph);
  }
  EXPECT_NO_THROW(executor.wait());
}

TEST_F(GraphExecutor, KeepsImagesUntilNoGraphDeclaresThem) {
  Executor executor(tools());
  const auto run_clear = [&](const char* pass) {
    Graph graph;
    static_cast<void>(add_clear(graph, pass));
    executor.run(graph);
  };
  run_clear("frame");
  run_clear("display");
  EXPECT_EQ(kept(executor), (Names{"display.image*", "frame.image"}));
  executor.sweep();
  EXPECT_EQ(kept(executor), (Names{"display.image*", "frame.image"})) << "both are of this picture";
  EXPECT_NE(executor.find_image("display.image"), nullptr);
  run_clear("display");
  executor.sweep();
  EXPECT_EQ(kept(executor), (Names{"display.image*"}));
  executor.sweep();
  EXPECT_EQ(kept(executor), Names{});
  EXPECT_EQ(executor.find_image("display.image"), nullptr);
  run_clear("display");
  EXPECT_EQ(kept(executor), (Names{"display.image*"}));
}

TEST_F(GraphExecutor, SweepsHistoryThatNoGraphDeclares) {
  Executor executor(tools());
  expect_count(executor, 1, 1);
  executor.sweep();
  expect_count(executor, 1, 2);
  executor.sweep();
  executor.sweep();
  EXPECT_EQ(kept(executor), Names{});
  expect_count(executor, 1, 1);
}

TEST(GpuDevice, GivesUpARecordingWhileOtherWorkRuns) {
  gpu::Device device(test::device_choice(), true);
  const gpu::Buffer buffer(device, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::readback);
  const auto fill = [&](std::uint32_t value) {
    const VkCommandBuffer commands = device.begin();
    gpu::record(commands, gpu::memory_barrier(gpu::kAllWork, gpu::kTransferWrite));
    vkCmdFillBuffer(commands, buffer.vk(), 0, 64, value);
    return commands;
  };
  const auto first = device.submit(fill(1));
  static_cast<void>(fill(2));
  const auto third = device.submit(fill(3));
  EXPECT_GT(third, first);
  EXPECT_NO_THROW(device.wait(third));
  EXPECT_EQ(buffer.mapped_as<std::uint32_t>()[0], 3u);
  EXPECT_NO_THROW(device.wait(first));
}

}  // namespace
}  // namespace velarium::graph
