// What a graph refuses, and the names it gives.

#include "refusals.hpp"

#include "graph/plan.hpp"

namespace velarium::graph {
namespace {

constexpr gpu::ImageDesc kColor{.format = VK_FORMAT_R16G16B16A16_SFLOAT, .width = 8, .height = 8};

TEST(Graph, RefusesToReadAnOldVersion) {
  Graph graph;
  auto& first = graph.pass("first");
  const auto old = first.write(graph.image("color", kColor), Access::compute_storage);
  const auto fresh = graph.pass("second").write(old, Access::compute_storage);
  EXPECT_EQ(fresh.version, old.version + 1);
  expect_internal_error([&] { graph.pass("third").read(old, Access::compute_sample); }, "'third' uses version 1");
  EXPECT_NO_THROW(graph.pass("fourth").read(fresh, Access::compute_sample));
}

TEST(Graph, RefusesToWriteAnOldVersion) {
  Graph graph;
  const auto image = graph.image("color", kColor);
  const auto written = graph.pass("first").write(image, Access::compute_storage);
  EXPECT_EQ(written.index, image.index);
  expect_internal_error([&] { static_cast<void>(graph.pass("second").write(image, Access::compute_storage)); },
                        "whose newest is 1");
}

TEST(Graph, RefusesToReadWhatNobodyWrote) {
  Graph graph;
  const auto image = graph.image("color", kColor);
  const auto buffer = graph.buffer("lights", 64);
  expect_internal_error([&] { graph.pass("shade").read(image, Access::compute_sample); }, "before any pass wrote it");
  expect_internal_error([&] { graph.pass("cull").read(buffer, Access::compute_sample); }, "before any pass wrote it");
}

TEST(Graph, RefusesOldVersionsOfBuffers) {
  Graph graph;
  const auto old = graph.pass("clear").write(graph.buffer("lights", 64), Access::transfer_write);
  const auto fresh = graph.pass("fill").write(old, Access::compute_storage);
  EXPECT_EQ(fresh.version, 2u);
  expect_internal_error([&] { graph.pass("shade").read(old, Access::compute_sample); }, "'clear.lights'");
}

TEST(Graph, AnImportedImageIsReadableOnlyIfInitialized) {
  gpu::Image kept;
  Graph graph;
  const auto with_contents = graph.import("history", kept, true);
  EXPECT_NO_THROW(graph.pass("blend").read(with_contents, Access::compute_sample));
  const auto without = graph.import("fresh", kept, false);
  expect_internal_error([&] { graph.pass("blend").read(without, Access::compute_sample); }, "before any pass wrote it");
}

TEST(Graph, RefusesTwoLayoutsInOnePass) {
  Graph graph;
  const auto image = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  auto& pass = graph.pass("blur");
  pass.read(image, Access::compute_sample);
  EXPECT_EQ(pass.write(image, Access::compute_storage).version, 2u);
  expect_internal_error([&] { static_cast<void>(plan(graph)); }, "'blur' uses 'draw.color' in two image layouts");
}

TEST(Graph, RefusesAWriteThroughAnAccessThatReads) {
  Graph graph;
  auto& pass = graph.pass("one");
  const auto image = graph.image("image", kColor);
  const auto buffer = graph.buffer("buffer", 4);
  expect_internal_error([&] { static_cast<void>(pass.write(image, Access::compute_sample)); }, "only reads");
  expect_internal_error([&] { static_cast<void>(pass.write(buffer, Access::host_read)); }, "only reads");
}

TEST(Graph, RefusesTwoResourcesOfOneName) {
  Graph graph;
  auto& pass = graph.pass("one");
  static_cast<void>(pass.write(graph.image("image", kColor), Access::compute_storage));
  expect_internal_error([&] { static_cast<void>(pass.write(graph.image("image", kColor), Access::compute_storage)); },
                        "'one.image'");
}

TEST(Graph, NamesAreThoseOfTheFirstWriter) {
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  EXPECT_EQ(graph.pass("tint").write(color, Access::compute_storage).version, 2u);
  EXPECT_EQ(graph.images()[color.index].name, "draw.color");
}

TEST(Graph, UsagesAreThoseOfAllPasses) {
  Graph graph;
  const auto color = graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
  graph.pass("shade").read(color, Access::compute_sample).read(color, Access::fragment_sample);
  graph.pass("copy").read(color, Access::transfer_read);
  EXPECT_EQ(graph.images()[color.index].usage,
            static_cast<VkImageUsageFlags>(VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                           VK_IMAGE_USAGE_TRANSFER_SRC_BIT));
}

TEST(Graph, AnImportedBufferIsReadableOnlyIfInitialized) {
  gpu::Buffer kept;
  Graph graph;
  const auto with_contents = graph.import("table", kept, true);
  EXPECT_NO_THROW(graph.pass("look up").read(with_contents, Access::compute_sample));
  const auto without = graph.import("fresh", kept, false);
  expect_internal_error([&] { graph.pass("look up").read(without, Access::compute_sample); },
                        "before any pass wrote it");
  const auto written = graph.pass("fill").write(without, Access::compute_storage);
  EXPECT_EQ(graph.buffers()[written.index].name, "fill.fresh");
  EXPECT_EQ(graph.buffers()[with_contents.index].name, "table");
}

TEST(Graph, RefusesA3dImageAsATarget) {
  Graph graph;
  const auto volume = graph.image("volume", {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .depth = 4});
  auto& pass = graph.pass("draw");
  expect_internal_error([&] { static_cast<void>(pass.write(volume, Access::color_attachment)); },
                        "'draw' has the 3-D image 'volume' as a target");
  EXPECT_EQ(pass.write(volume, Access::compute_storage).version, 1u);
}

}  // namespace
}  // namespace velarium::graph
