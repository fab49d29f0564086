// Names in a graph that declares the same passes several times.

#include "refusals.hpp"

#include "graph/plan.hpp"

namespace velarium::graph {
namespace {

constexpr gpu::ImageDesc kColor{.format = VK_FORMAT_R16G16B16A16_SFLOAT, .width = 8, .height = 8};

GraphImage draw(Graph& graph) {
  return graph.pass("draw").write(graph.image("color", kColor), Access::color_attachment);
}

TEST(Scopes, BeginTheNamesOfPassesAndOfWhatTheyWrite) {
  Graph graph;
  const auto inside = [&] {
    const auto scope = graph.scope("face+x");
    return draw(graph);
  }();
  const auto outside = draw(graph);
  EXPECT_EQ(graph.passes()[0].name(), "face+x/draw");
  EXPECT_EQ(graph.passes()[1].name(), "draw");
  EXPECT_EQ(graph.images()[inside.index].name, "face+x/draw.color");
  EXPECT_EQ(graph.images()[outside.index].name, "draw.color");
}

TEST(Scopes, LetAFrameBeDeclaredSeveralTimes) {
  Graph graph;
  for (const char* face : {"face+x", "face-x"}) {
    const auto scope = graph.scope(face);
    EXPECT_NO_THROW(static_cast<void>(draw(graph)));
  }
  const auto again = graph.scope("face+x");
  expect_internal_error([&] { static_cast<void>(draw(graph)); }, "two resources named 'face+x/draw.color'");
}

TEST(Scopes, Nest) {
  Graph graph;
  const auto probe = graph.scope("probe");
  {
    const auto face = graph.scope("face+x");
    static_cast<void>(draw(graph));
  }
  static_cast<void>(draw(graph));
  EXPECT_EQ(graph.passes()[0].name(), "probe/face+x/draw");
  EXPECT_EQ(graph.passes()[1].name(), "probe/draw");
}

TEST(Scopes, OfNoNameChangeNothing) {
  Graph graph;
  const auto scope = graph.scope("");
  static_cast<void>(draw(graph));
  EXPECT_EQ(graph.passes()[0].name(), "draw");
}

TEST(Scopes, BeginTheNamesOfImports) {
  gpu::Image image;
  gpu::Buffer buffer;
  Graph graph;
  const auto scope = graph.scope("left");
  const auto kept = graph.import("map", image, true);
  const auto fresh = graph.pass("sum up").write(graph.import("sum", image, false), Access::compute_storage);
  const auto table = graph.import("table", buffer, true);
  const auto filled = graph.pass("fill").write(graph.buffer("list", 64), Access::compute_storage);
  EXPECT_EQ(graph.images()[kept.index].name, "left/map");
  EXPECT_EQ(graph.images()[fresh.index].name, "left/sum up.sum");
  EXPECT_EQ(graph.buffers()[table.index].name, "left/table");
  EXPECT_EQ(graph.buffers()[filled.index].name, "left/fill.list");
}

TEST(Scopes, NameWhatRefusalsAreAbout) {
  Graph graph;
  const auto scope = graph.scope("right");
  const auto old = draw(graph);
  static_cast<void>(graph.pass("redraw").write(old, Access::color_attachment));
  expect_internal_error([&] { graph.pass("tint").read(old, Access::compute_sample); },
                        "pass 'right/tint' uses version 1 of 'right/draw.color'");
}

}  // namespace
}  // namespace velarium::graph
