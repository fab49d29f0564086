// What a graph refuses, and the names it gives.

#include "graph/plan.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

namespace velarium::graph {
namespace {

constexpr gpu::ImageDesc kColor{.format = VK_FORMAT_R16G16B16A16_SFLOAT, .width = 8, .height = 8};

template <class Deed>
void expect_internal_error(const Deed& deed, const std::string& part_of_message) {
  try {
    deed();
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::internal);
    EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos) << error.what();
  }
}

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

}  // namespace
}  // namespace velarium::graph
