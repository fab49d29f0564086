// The barriers that a graph plans, case by case. No device is needed.

#include "graph/plan.hpp"

#include <gtest/gtest.h>

namespace velarium::graph {
namespace {

constexpr gpu::ImageDesc kColor{.format = VK_FORMAT_R16G16B16A16_SFLOAT, .width = 8, .height = 8};
constexpr gpu::ImageDesc kDepth{.format = VK_FORMAT_D32_SFLOAT_S8_UINT, .width = 8, .height = 8};

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kFragment = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 kColorOutput = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkPipelineStageFlags2 kDepthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

// Every bit of `wanted` is in `flags`.
bool holds(VkFlags64 flags, VkFlags64 wanted) {
  return (flags & wanted) == wanted;
}

TEST(Plan, FirstWriteDiscardsWhatWasThere) {
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[0].images.size(), 1u);
  const auto& barrier = planned[0].images[0];
  EXPECT_EQ(barrier.index, color.index);
  EXPECT_EQ(barrier.src_stages, 0u);
  EXPECT_EQ(barrier.src_access, 0u);
  EXPECT_EQ(barrier.old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(barrier.new_layout, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  EXPECT_EQ(barrier.dst_stages, kColorOutput);
}

TEST(Plan, ASecondReadingStageKeepsItsBarrier) {
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  graph.pass("shade").read(color, Access::compute_sample);
  graph.pass("blend").read(color, Access::fragment_sample);
  const auto planned = plan(graph).passes;

  ASSERT_EQ(planned[1].images.size(), 1u);
  EXPECT_EQ(planned[1].images[0].src_stages, kColorOutput);
  EXPECT_EQ(planned[1].images[0].src_access, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
  EXPECT_EQ(planned[1].images[0].dst_stages, kCompute);
  EXPECT_TRUE(holds(planned[1].images[0].dst_access, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT));

  ASSERT_EQ(planned[2].images.size(), 1u) << "the fragment stage has not seen the write";
  const auto& second = planned[2].images[0];
  // The layout was changed before the compute read: the new barrier must chain on that one.
  EXPECT_TRUE(holds(second.src_stages, kColorOutput | kCompute));
  EXPECT_EQ(second.src_access, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
  EXPECT_TRUE(holds(second.dst_stages, kFragment));
  EXPECT_EQ(second.old_layout, second.new_layout);
}

TEST(Plan, ASecondReadAtOneStageNeedsNoBarrier) {
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  graph.pass("first").read(color, Access::compute_sample);
  graph.pass("second").read(color, Access::compute_sample);
  const auto planned = plan(graph).passes;
  EXPECT_EQ(planned[1].images.size(), 1u);
  EXPECT_TRUE(planned[2].images.empty());
}

TEST(Plan, AWriteWaitsForReadersButFlushesNothing) {
  Graph graph;
  const auto color = graph.pass("fill").write(graph.image("color", kColor), Access::compute_storage);
  graph.pass("read").read(color, Access::compute_storage);
  static_cast<void>(graph.pass("refill").write(color, Access::compute_storage));
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[2].images.size(), 1u);
  EXPECT_TRUE(holds(planned[2].images[0].src_stages, kCompute));
  EXPECT_EQ(planned[2].images[0].src_access, 0u) << "the readers' barrier has flushed the write: execution is enough";
}

TEST(Plan, AWriteWaitsForReadersOfEveryStage) {
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  graph.pass("shade").read(color, Access::compute_sample);
  graph.pass("blend").read(color, Access::fragment_sample);
  static_cast<void>(graph.pass("redraw").write(color, Access::color_attachment));
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[3].images.size(), 1u);
  EXPECT_TRUE(holds(planned[3].images[0].src_stages, kCompute | kFragment));
  EXPECT_EQ(planned[3].images[0].old_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

TEST(Plan, ALayoutChangeBetweenReadersWaitsForThem) {
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  graph.pass("shade").read(color, Access::compute_sample);
  graph.pass("copy").read(color, Access::transfer_read);
  graph.pass("shade again").read(color, Access::compute_sample);
  const auto planned = plan(graph).passes;

  ASSERT_EQ(planned[2].images.size(), 1u);
  EXPECT_TRUE(holds(planned[2].images[0].src_stages, kCompute));
  EXPECT_EQ(planned[2].images[0].old_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  EXPECT_EQ(planned[2].images[0].new_layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);

  ASSERT_EQ(planned[3].images.size(), 1u) << "the compute stage saw the image in another layout";
  EXPECT_TRUE(holds(planned[3].images[0].src_stages, kTransfer));
  EXPECT_EQ(planned[3].images[0].new_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

TEST(Plan, AWriteAfterAWriteFlushesTheFirst) {
  Graph graph;
  const auto once = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  static_cast<void>(graph.pass("draw more").write(once, Access::color_attachment));
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[1].images.size(), 1u);
  const auto& barrier = planned[1].images[0];
  EXPECT_EQ(barrier.src_stages, kColorOutput);
  EXPECT_EQ(barrier.src_access, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
  EXPECT_TRUE(
      holds(barrier.dst_access, VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT));
  EXPECT_EQ(barrier.old_layout, barrier.new_layout);
}

TEST(Plan, DepthIsSampledAndTestedInOnePassBehindOneBarrier) {
  Graph graph;
  const auto depth = graph.pass("gbuffer").write(graph.image("depth", kDepth), Access::depth_attachment);
  auto& pass = graph.pass("decals");
  pass.read(depth, Access::depth_test);
  pass.read(depth, Access::fragment_sample);
  const auto planned = plan(graph).passes;

  EXPECT_EQ(planned[0].images[0].new_layout, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
  ASSERT_EQ(planned[1].images.size(), 1u);
  const auto& barrier = planned[1].images[0];
  EXPECT_EQ(barrier.src_stages, kDepthTests);
  EXPECT_EQ(barrier.src_access, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT);
  EXPECT_TRUE(holds(barrier.dst_stages, kDepthTests | kFragment));
  EXPECT_TRUE(
      holds(barrier.dst_access, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT));
  EXPECT_EQ(barrier.new_layout, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
}

TEST(Plan, DepthSampledInComputeThenTestedNeedsBothStages) {
  Graph graph;
  const auto depth = graph.pass("gbuffer").write(graph.image("depth", kDepth), Access::depth_attachment);
  graph.pass("occlusion").read(depth, Access::compute_sample);
  graph.pass("glass").read(depth, Access::depth_test);
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[1].images.size(), 1u);
  ASSERT_EQ(planned[2].images.size(), 1u);
  EXPECT_EQ(planned[2].images[0].old_layout, planned[2].images[0].new_layout);
  EXPECT_TRUE(holds(planned[2].images[0].src_stages, kDepthTests | kCompute));
}

TEST(Plan, AnImportedImageWaitsForAnyoneBeforeTheFrame) {
  gpu::Image kept;
  kept.layout = VK_IMAGE_LAYOUT_GENERAL;
  Graph graph;
  const auto history = graph.import("history", kept, true);
  graph.pass("blend").read(history, Access::compute_sample);
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[0].images.size(), 1u);
  const auto& barrier = planned[0].images[0];
  EXPECT_EQ(barrier.src_stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
  EXPECT_EQ(barrier.src_access, VK_ACCESS_2_MEMORY_WRITE_BIT);
  EXPECT_EQ(barrier.old_layout, VK_IMAGE_LAYOUT_GENERAL);
  EXPECT_EQ(barrier.new_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

TEST(Plan, AnImportedImageAlreadyInItsLayoutStillWaits) {
  gpu::Image kept;
  kept.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  Graph graph;
  graph.pass("blend").read(graph.import("history", kept, true), Access::compute_sample);
  EXPECT_EQ(plan(graph).passes[0].images.size(), 1u);
}

TEST(Plan, BuffersGoFromWriterToReaderToHost) {
  Graph graph;
  const auto buffer = graph.pass("fill").write(graph.buffer("values", 64), Access::compute_storage);
  const auto host = graph.buffer("values", 64, gpu::MemoryUse::readback);
  auto& copy = graph.pass("copy");
  copy.read(buffer, Access::transfer_read);
  const auto copied = copy.write(host, Access::transfer_write);
  graph.pass("hand over").read(copied, Access::host_read);
  const auto planned = plan(graph).passes;

  EXPECT_TRUE(planned[0].buffers.empty()) << "nobody used the buffer before";
  ASSERT_EQ(planned[1].buffers.size(), 1u);
  EXPECT_EQ(planned[1].buffers[0].index, buffer.index);
  EXPECT_EQ(planned[1].buffers[0].src_access, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
  EXPECT_EQ(planned[1].buffers[0].dst_access, VK_ACCESS_2_TRANSFER_READ_BIT);
  ASSERT_EQ(planned[2].buffers.size(), 1u);
  EXPECT_EQ(planned[2].buffers[0].src_stages, kTransfer);
  EXPECT_EQ(planned[2].buffers[0].src_access, VK_ACCESS_2_TRANSFER_WRITE_BIT);
  EXPECT_EQ(planned[2].buffers[0].dst_stages, VK_PIPELINE_STAGE_2_HOST_BIT);
  EXPECT_EQ(planned[2].buffers[0].dst_access, VK_ACCESS_2_HOST_READ_BIT);
}

TEST(Plan, AStageThatSawOneKindOfReadIsNotTakenForAnother) {
  Graph graph;
  const auto buffer = graph.pass("fill").write(graph.buffer("values", 64), Access::transfer_write);
  graph.pass("load").read(buffer, Access::compute_storage);    // storage reads in compute
  graph.pass("draw").read(buffer, Access::fragment_sample);    // uniform reads, but in the fragment stage
  graph.pass("uniform").read(buffer, Access::compute_sample);  // uniform reads in compute: seen by nobody yet
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[3].buffers.size(), 1u);
  EXPECT_TRUE(holds(planned[3].buffers[0].dst_access, VK_ACCESS_2_UNIFORM_READ_BIT));
}

TEST(Plan, ReadsNeverAskForWriteAccess) {
  Graph graph;
  const auto color = graph.pass("fill").write(graph.image("color", kColor), Access::compute_storage);
  graph.pass("load").read(color, Access::compute_storage);
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[1].images.size(), 1u);
  EXPECT_EQ(planned[1].images[0].dst_access, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
}

TEST(Plan, ResourcesDoNotDisturbEachOther) {
  Graph graph;
  auto& draw = graph.pass("draw");
  const auto a = draw.write(graph.image("a", kColor), Access::color_attachment);
  const auto b = draw.write(graph.image("b", kColor), Access::color_attachment);
  graph.pass("read a").read(a, Access::compute_sample);
  graph.pass("read b").read(b, Access::compute_sample);
  const auto planned = plan(graph).passes;
  EXPECT_EQ(planned[0].images.size(), 2u);
  ASSERT_EQ(planned[1].images.size(), 1u);
  EXPECT_EQ(planned[1].images[0].index, a.index);
  ASSERT_EQ(planned[2].images.size(), 1u);
  EXPECT_EQ(planned[2].images[0].index, b.index);
}

TEST(Plan, AnImportedBufferWaitsForAnyoneBeforeTheFrame) {
  gpu::Buffer kept;
  Graph graph;
  const auto table = graph.import("table", kept, true);
  graph.pass("look up").read(table, Access::compute_sample);
  graph.pass("look up again").read(table, Access::compute_sample);
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[0].buffers.size(), 1u);
  EXPECT_EQ(planned[0].buffers[0].index, table.index);
  EXPECT_EQ(planned[0].buffers[0].src_stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
  EXPECT_EQ(planned[0].buffers[0].src_access, VK_ACCESS_2_MEMORY_WRITE_BIT);
  EXPECT_EQ(planned[0].buffers[0].dst_stages, kCompute);
  EXPECT_TRUE(planned[1].buffers.empty());
}

TEST(Plan, AWriteToAnImportedBufferWaitsToo) {
  gpu::Buffer kept;
  Graph graph;
  static_cast<void>(graph.pass("fill").write(graph.import("table", kept, false), Access::compute_storage));
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[0].buffers.size(), 1u);
  EXPECT_EQ(planned[0].buffers[0].src_stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
}

TEST(Plan, WhileAGraphRunsTheNextWaitsForItsImagesAndBuffers) {
  Graph graph;
  auto& pass = graph.pass("fill");
  static_cast<void>(pass.write(graph.image("color", kColor), Access::compute_storage));
  static_cast<void>(pass.write(graph.buffer("values", 64), Access::compute_storage));
  const auto alone = plan(graph).passes;
  EXPECT_EQ(alone[0].images[0].src_stages, 0u);
  EXPECT_TRUE(alone[0].buffers.empty());
  const auto behind = plan(graph, Before::running).passes;
  ASSERT_EQ(behind[0].images.size(), 1u);
  EXPECT_EQ(behind[0].images[0].src_stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
  EXPECT_EQ(behind[0].images[0].old_layout, VK_IMAGE_LAYOUT_UNDEFINED) << "what was in it is still discarded";
  ASSERT_EQ(behind[0].buffers.size(), 1u);
  EXPECT_EQ(behind[0].buffers[0].src_stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
}

TEST(Plan, SaysInWhichLayoutsImagesAreLeft) {
  gpu::Image kept;
  kept.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  graph.pass("shade").read(color, Access::compute_sample);
  const auto unused = graph.import("unused", kept, true);
  const auto planned = plan(graph);
  EXPECT_EQ(planned.final_layouts[color.index], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  EXPECT_EQ(planned.final_layouts[unused.index], VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  EXPECT_TRUE(planned.closing.empty());
}

}  // namespace
}  // namespace velarium::graph
