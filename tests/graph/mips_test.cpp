// Chains of mips: what a handle that names one may do, and the barriers between them.

#include "refusals.hpp"

#include "graph/plan.hpp"

namespace velarium::graph {
namespace {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkImageLayout kStored = VK_IMAGE_LAYOUT_GENERAL, kSampled = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
constexpr gpu::ImageDesc kChain{.format = VK_FORMAT_R32_SFLOAT, .width = 8, .height = 8, .mips = 4};

// Each mip from the one before; returns the handle of the whole.
GraphImage add_chain(Graph& graph, std::uint32_t mips) {
  auto chain = graph.pass("first").write(graph.image("chain", kChain).at(0), Access::compute_storage);
  for (std::uint32_t mip = 1; mip < mips; ++mip) {
    auto& pass = graph.pass("halve");
    pass.read(chain.at(mip - 1), Access::compute_sample);
    chain = pass.write(chain.at(mip), Access::compute_storage);
  }
  return chain.whole();
}

TEST(Mips, AWriteReturnsTheMipThatItNamed) {
  Graph graph;
  const auto image = graph.image("chain", kChain);
  const auto written = graph.pass("first").write(image.at(2), Access::compute_storage);
  EXPECT_EQ(written.mip, 2u);
  EXPECT_EQ(written.version, 1u);
  EXPECT_EQ(written.whole().at(2), written);
}

TEST(Mips, OneIsSampledWhileTheNextIsStored) {
  Graph graph;
  const auto chain = add_chain(graph, 2);
  const auto planned = plan(graph).passes;

  ASSERT_EQ(planned[0].images.size(), 1u);
  EXPECT_EQ(planned[0].images[0].mips, (gpu::MipRange{0, 1}));
  EXPECT_EQ(planned[0].images[0].old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(planned[0].images[0].new_layout, kStored);

  ASSERT_EQ(planned[1].images.size(), 2u);
  const auto& read = planned[1].images[0];
  EXPECT_EQ(read.index, chain.index);
  EXPECT_EQ(read.mips, (gpu::MipRange{0, 1}));
  EXPECT_EQ(read.src_stages, kCompute);
  EXPECT_EQ(read.src_access, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
  EXPECT_EQ(read.old_layout, kStored);
  EXPECT_EQ(read.new_layout, kSampled);
  const auto& written = planned[1].images[1];
  EXPECT_EQ(written.mips, (gpu::MipRange{1, 1}));
  EXPECT_EQ(written.src_stages, 0u) << "nobody has used this mip";
  EXPECT_EQ(written.old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(written.new_layout, kStored);
}

TEST(Mips, TheWholeChainIsSampledBehindTheLastMip) {
  Graph graph;
  const auto chain = add_chain(graph, 4);
  graph.pass("look up").read(chain, Access::compute_sample);
  const auto planned = plan(graph);
  ASSERT_EQ(planned.passes[4].images.size(), 1u) << "the other mips were sampled at this stage already";
  EXPECT_EQ(planned.passes[4].images[0].mips, (gpu::MipRange{3, 1}));
  EXPECT_TRUE(planned.closing.empty());
  EXPECT_EQ(planned.final_layouts[chain.index], kSampled);
}

TEST(Mips, ThoseThatNeedTheSameShareABarrier) {
  Graph graph;
  const auto chain = add_chain(graph, 4);
  graph.pass("draw with").read(chain, Access::fragment_sample);
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[4].images.size(), 2u) << "all mips but the last were sampled before";
  EXPECT_EQ(planned[4].images[0].mips, (gpu::MipRange{0, 3}));
  EXPECT_EQ(planned[4].images[0].old_layout, kSampled);
  EXPECT_EQ(planned[4].images[1].mips, (gpu::MipRange{3, 1}));
  EXPECT_EQ(planned[4].images[1].old_layout, kStored);
}

TEST(Mips, AWriteOfTheWholeIsOneBarrier) {
  Graph graph;
  static_cast<void>(graph.pass("clear").write(graph.image("chain", kChain), Access::transfer_write));
  const auto planned = plan(graph).passes;
  ASSERT_EQ(planned[0].images.size(), 1u);
  EXPECT_EQ(planned[0].images[0].mips, (gpu::MipRange{0, 4}));
}

TEST(Mips, AreLeftInOneLayout) {
  Graph graph;
  const auto chain = add_chain(graph, 3);  // ends sampled, sampled, stored, never used
  const auto planned = plan(graph);
  EXPECT_EQ(planned.final_layouts[chain.index], kSampled);
  ASSERT_EQ(planned.closing.size(), 2u);
  EXPECT_EQ(planned.closing[0].mips, (gpu::MipRange{2, 1}));
  EXPECT_EQ(planned.closing[0].src_stages, kCompute);
  EXPECT_EQ(planned.closing[0].src_access, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
  EXPECT_EQ(planned.closing[0].old_layout, kStored);
  EXPECT_EQ(planned.closing[0].new_layout, kSampled);
  EXPECT_EQ(planned.closing[1].mips, (gpu::MipRange{3, 1}));
  EXPECT_EQ(planned.closing[1].old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
}

TEST(Mips, AHandleFromBeforeAnotherMipWasWrittenIsFresh) {
  Graph graph;
  const auto image = graph.image("chain", kChain);
  auto& pass = graph.pass("both");
  const auto first = pass.write(image.at(0), Access::compute_storage);
  const auto second = pass.write(image.at(1), Access::compute_storage);
  EXPECT_EQ(second.version, 2u);
  EXPECT_NO_THROW(graph.pass("later").read(first, Access::compute_sample));
  EXPECT_NO_THROW(graph.pass("later").read(second.at(0), Access::compute_sample));
}

TEST(Mips, RefuseStaleHandles) {
  Graph graph;
  const auto old = add_chain(graph, 4);
  static_cast<void>(graph.pass("sharpen").write(old.at(1), Access::compute_storage));
  expect_internal_error([&] { graph.pass("blur").read(old.at(1), Access::compute_sample); },
                        "pass 'blur' uses version 4 of mip 1 of 'first.chain', whose newest is 5");
  expect_internal_error([&] { graph.pass("blur").read(old, Access::compute_sample); },
                        "pass 'blur' uses version 4 of 'first.chain', whose newest is 5");
  expect_internal_error([&] { static_cast<void>(graph.pass("blur").write(old.at(1), Access::compute_storage)); },
                        "whose newest is 5");
  EXPECT_NO_THROW(graph.pass("blur").read(old.at(2), Access::compute_sample));
}

TEST(Mips, RefuseAReadOfAMipThatNobodyWrote) {
  Graph graph;
  const auto chain = add_chain(graph, 2);
  expect_internal_error([&] { graph.pass("blur").read(chain.at(3), Access::compute_sample); },
                        "pass 'blur' reads mip 3 of 'first.chain' before any pass wrote it");
  expect_internal_error([&] { graph.pass("blur").read(chain, Access::compute_sample); },
                        "pass 'blur' reads mip 2 of 'first.chain' before any pass wrote it");
}

TEST(Mips, RefuseAMipThatIsNotThere) {
  Graph graph;
  const auto image = graph.image("chain", kChain);
  expect_internal_error([&] { static_cast<void>(graph.pass("first").write(image.at(4), Access::compute_storage)); },
                        "pass 'first' uses mip 4 of 'chain', which has 4");
}

TEST(Mips, RefuseToBeSampledAndStoredAtOnce) {
  Graph graph;
  const auto chain = add_chain(graph, 4);
  auto& pass = graph.pass("blur");
  pass.read(chain, Access::compute_sample);
  static_cast<void>(pass.write(chain.at(2), Access::compute_storage));
  expect_internal_error([&] { static_cast<void>(plan(graph)); },
                        "pass 'blur' uses mip 2 of 'first.chain' in two image layouts");
}

TEST(Mips, RefuseToBeOneTarget) {
  Graph graph;
  const auto image = graph.image("chain", kChain);
  auto& pass = graph.pass("draw");
  expect_internal_error([&] { static_cast<void>(pass.write(image, Access::color_attachment)); },
                        "pass 'draw' has all mips of 'chain' as one target");
  EXPECT_NO_THROW(static_cast<void>(pass.write(image.at(1), Access::color_attachment)));
}

TEST(Mips, OfAnImportedImageBeginInItsLayout) {
  gpu::Image kept;  // has one mip
  kept.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  Graph graph;
  graph.pass("blend").read(graph.import("kept", kept, true).at(0), Access::compute_sample);
  const auto planned = plan(graph);
  ASSERT_EQ(planned.passes[0].images.size(), 1u);
  EXPECT_EQ(planned.passes[0].images[0].old_layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  EXPECT_EQ(planned.final_layouts[0], kSampled);
}

}  // namespace
}  // namespace velarium::graph
