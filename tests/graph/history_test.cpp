// Images of the frame before: what a graph may do with them, and when there are any. No device is needed.

#include "refusals.hpp"

#include "graph/plan.hpp"

namespace velarium::graph {
namespace {

constexpr gpu::ImageDesc kColor{.format = VK_FORMAT_R16G16B16A16_SFLOAT, .width = 8, .height = 8};

// A frame that blends with the one before.
History add_blend(Graph& graph, const gpu::ImageDesc& desc = kColor) {
  const auto color = graph.history("taa.color", desc);
  auto& pass = graph.pass("taa");
  pass.read(color.previous, Access::compute_sample);
  static_cast<void>(pass.write(color.current, Access::compute_storage));
  return color;
}

// As the executor does around a graph, but for images.
void run(HistoryStore& store, const Graph& graph) {
  store.refuse_outdated(graph);
  for (const auto& history : graph.histories()) store.pair(history.name).desc = graph.images()[history.current].desc;
  store.advance(graph);
}

TEST(History, HasContentsFromTheSecondFrameOn) {
  HistoryStore store;
  for (int frame = 0; frame < 3; ++frame) {
    Graph graph(&store);
    EXPECT_EQ(add_blend(graph).has_contents, frame > 0);
    run(store, graph);
  }
}

TEST(History, WhatIsWrittenIsReadInTheNextFrame) {
  HistoryStore store;
  Graph first(&store);
  const auto a = add_blend(first);
  const gpu::Image* written = first.images()[a.current.index].imported;
  EXPECT_NE(written, first.images()[a.previous.index].imported);
  run(store, first);
  Graph second(&store);
  const auto b = add_blend(second);
  EXPECT_EQ(second.images()[b.previous.index].imported, written);
  EXPECT_NE(second.images()[b.current.index].imported, written);
}

TEST(History, OfAnotherKindOfImageBeginsAnew) {
  HistoryStore store;
  Graph first(&store), second(&store);
  EXPECT_FALSE(add_blend(first).has_contents);
  run(store, first);
  Graph larger(&store);
  EXPECT_FALSE(add_blend(larger, {.format = kColor.format, .width = 9, .height = 8}).has_contents);
}

TEST(History, IsForgottenForANewPicture) {
  HistoryStore store;
  Graph first(&store);
  static_cast<void>(add_blend(first));
  run(store, first);
  store.forget();
  Graph second(&store);
  EXPECT_FALSE(add_blend(second).has_contents);
}

TEST(History, IsKeptByGraphsThatDoNotDeclareIt) {
  HistoryStore store;
  Graph first(&store);
  static_cast<void>(add_blend(first));
  run(store, first);
  run(store, Graph(&store));
  Graph second(&store);
  EXPECT_TRUE(add_blend(second).has_contents);
}

TEST(History, NamesAreFullAndScoped) {
  HistoryStore store;
  Graph graph(&store);
  const auto left = [&] {
    const auto scope = graph.scope("left");
    return add_blend(graph);
  }();
  const auto right = add_blend(graph);
  EXPECT_EQ(graph.images()[left.current.index].name, "left/taa.color");
  EXPECT_EQ(graph.images()[left.previous.index].name, "left/taa.color.previous");
  EXPECT_EQ(graph.images()[right.current.index].name, "taa.color");
  EXPECT_NE(graph.images()[left.current.index].imported, graph.images()[right.current.index].imported);
}

TEST(History, BarriersWaitForTheFrameBefore) {
  HistoryStore store;
  store.pair("taa.color").newest().layout = VK_IMAGE_LAYOUT_GENERAL;
  Graph graph(&store);
  const auto color = add_blend(graph);
  const auto planned = plan(graph);
  ASSERT_EQ(planned.passes[0].images.size(), 2u);
  const auto& read = planned.passes[0].images[0];
  EXPECT_EQ(read.index, color.previous.index);
  EXPECT_EQ(read.src_stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
  EXPECT_EQ(read.src_access, VK_ACCESS_2_MEMORY_WRITE_BIT);
  EXPECT_EQ(read.old_layout, VK_IMAGE_LAYOUT_GENERAL);
  EXPECT_EQ(read.new_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  EXPECT_EQ(planned.passes[0].images[1].index, color.current.index);
  EXPECT_EQ(planned.passes[0].images[1].src_stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT)
      << "the frame before reads it";
}

TEST(History, RefusesAGraphFromBeforeAnotherRan) {
  HistoryStore store;
  Graph first(&store), second(&store);
  static_cast<void>(add_blend(first));
  static_cast<void>(add_blend(second));
  run(store, first);
  expect_internal_error([&] { store.refuse_outdated(second); }, "history 'taa.color' has changed");
}

TEST(History, RefusesAGraphFromBeforeItWasForgotten) {
  HistoryStore store;
  Graph graph(&store);
  static_cast<void>(add_blend(graph));
  store.forget();
  expect_internal_error([&] { store.refuse_outdated(graph); }, "history 'taa.color' has changed");
}

TEST(History, RefusesAGraphThatDoesNotWriteIt) {
  HistoryStore store;
  Graph graph(&store);
  const auto color = graph.history("taa.color", kColor);
  graph.pass("taa").read(color.previous, Access::compute_sample);
  expect_internal_error([&] { static_cast<void>(plan(graph)); }, "history 'taa.color' is not written");
}

TEST(History, RefusesAGraphThatWritesSomeMips) {
  HistoryStore store;
  Graph graph(&store);
  const auto chain = graph.history("chain", {.format = kColor.format, .width = 8, .height = 8, .mips = 2});
  static_cast<void>(graph.pass("fill").write(chain.current.at(0), Access::compute_storage));
  expect_internal_error([&] { static_cast<void>(plan(graph)); }, "history 'chain' is not written, or not whole");
}

TEST(History, RefusesToReadThisFrameBeforeItIsWritten) {
  HistoryStore store;
  Graph graph(&store);
  const auto color = graph.history("taa.color", kColor);
  expect_internal_error([&] { graph.pass("taa").read(color.current, Access::compute_sample); },
                        "pass 'taa' reads 'taa.color' before any pass wrote it");
}

TEST(History, RefusesToWriteTheFrameBefore) {
  HistoryStore store;
  Graph graph(&store);
  const auto color = graph.history("taa.color", kColor);
  auto& pass = graph.pass("taa");
  for (const Access access : {Access::compute_storage, Access::color_attachment, Access::transfer_write})
    expect_internal_error([&] { static_cast<void>(pass.write(color.previous, access)); },
                          "pass 'taa' may only sample or copy 'taa.color.previous'");
  expect_internal_error([&] { pass.read(color.previous, Access::compute_storage); }, "may only sample or copy");
  EXPECT_NO_THROW(pass.read(color.previous, Access::fragment_sample));
}

TEST(History, RefusesASecondOfItsName) {
  HistoryStore store;
  Graph graph(&store);
  static_cast<void>(add_blend(graph));
  expect_internal_error([&] { static_cast<void>(graph.history("taa.color", kColor)); },
                        "'taa.color' is the second image of that name");
}

TEST(History, RefusesAGraphWithoutAnExecutors) {
  Graph graph;
  expect_internal_error([&] { static_cast<void>(graph.history("taa.color", kColor)); },
                        "without the executor's history");
}

}  // namespace
}  // namespace velarium::graph
