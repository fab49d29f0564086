// Techniques that look back: a toy one, the running difference of two frames, through the whole stack.

#include "support/frames.hpp"

#include "passes/io.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace velarium::test {
namespace {

namespace io {
using namespace shading;
#include "running_difference_io.glsl"
}  // namespace io

constexpr std::uint32_t kShader[] =
#include "shaders/pictures/running_difference.comp.inc"
    ;

constexpr std::uint32_t kWidth = 48, kHeight = 32;

// Replaces the sum by what it has more than that of the frame before.
graph::GraphImage add_difference(graph::Graph& graph, graph::GraphImage sum) {
  const auto history = graph.history("toy.frame", graph.desc(sum));
  auto& pass = graph.pass("toy");
  pass.read(history.previous, graph::Access::compute_sample);
  const auto after = pass.write(history.current, graph::Access::compute_storage);
  const auto difference = pass.write(sum, graph::Access::compute_storage);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kShader);
    c.bind(pipeline);
    c.set(pipeline, 0)
        .sampled(io::before, history.previous)
        .storage(io::after, after)
        .storage(io::sum, difference)
        .bind();
    c.dispatch(kWidth, kHeight, 8, 8);
  });
  return difference;
}

frame::Renderer looking_back() {
  return frame::Renderer(gpu_context(), {.add =
                                             [](graph::Graph& graph, const frame::FrameInputs& in) {
                                               return add_difference(graph, frame::add_frame(graph, in));
                                             },
                                         .looks_back = [](const Settings&) { return true; }});
}

RenderRequest small_request() {
  RenderRequest request;
  request.width = kWidth;
  request.height = kHeight;
  request.want_display = false;
  request.settings.frame.spp = 1;
  request.settings.local_shadows.atlas = 256;
  return request;
}

// Frame n of a walk.
scene::CameraInstance camera_at(int n) {
  const float x = 0.05f * static_cast<float>(n);
  return scene::look_at_camera({x, 1.0f, 3.2f}, {0.0f, 1.0f, 0.0f}, {0, 1, 0}, 0.7f);
}

class Walk {
 public:
  explicit Walk(frame::Renderer& renderer) : renderer_(renderer) {}

  std::vector<float> frame(int n) {
    const frame::JobBefore before{scene_.snapshot, camera_at(n - 1), key_of(n - 1)};
    return renderer_.render({*scene_.gpu, scene_.snapshot, camera_at(n), nullptr, request_, before, key_of(n)})
        .picture.linear;
  }
  std::vector<float> alone(int n) {
    return renderer_.render({*scene_.gpu, scene_.snapshot, camera_at(n), nullptr, request_}).picture.linear;
  }

 private:
  static std::uint64_t key_of(int n) { return static_cast<std::uint64_t>(n) + 100; }

  StillScene scene_{"cornell"};
  RenderRequest request_ = small_request();
  frame::Renderer& renderer_;
};

bool is_zero(const std::vector<float>& picture) {
  return std::ranges::all_of(picture, [](float value) { return value == 0.0f; });
}

// Made one after the other, in two halves, each by itself, or backwards: equal bytes.
TEST(FrameBefore, AnyChunksGiveEqualPictures) {
  constexpr int kFrames = 4;
  std::vector<std::vector<float>> whole;
  auto renderer = looking_back();
  Walk walk(renderer);
  for (int n = 0; n < kFrames; ++n) whole.push_back(walk.frame(n));
  EXPECT_FALSE(is_zero(whole[1]));

  for (int n = kFrames - 1; n >= 0; --n) {
    EXPECT_TRUE(walk.frame(n) == whole[static_cast<std::size_t>(n)]) << n;
    auto fresh = looking_back();
    Walk alone(fresh);
    EXPECT_TRUE(alone.frame(n) == whole[static_cast<std::size_t>(n)]) << n;
  }
}

TEST(FrameBefore, NothingMovesInAPictureThatStandsAlone) {
  auto renderer = looking_back();
  Walk walk(renderer);
  EXPECT_TRUE(is_zero(walk.alone(3)));
  EXPECT_FALSE(is_zero(walk.frame(3)));
  EXPECT_TRUE(is_zero(walk.alone(3)));  // whatever was drawn before
}

TEST(FrameBefore, ReachesTheFrame) {
  std::vector<glm::dvec3> eyes;
  frame::Renderer renderer(gpu_context(), {.add =
                                               [&](graph::Graph& graph, const frame::FrameInputs& in) {
                                                 eyes.push_back(in.before.view->matrices.eye);
                                                 return frame::add_frame(graph, in);
                                               },
                                           .looks_back = [](const Settings&) { return true; }});
  Walk walk(renderer);
  static_cast<void>(walk.frame(5));
  ASSERT_EQ(eyes.size(), 2u);  // one to warm up, which stands still
  EXPECT_EQ(eyes[0], glm::dvec3(camera_at(4).world_from_view[3]));
  EXPECT_EQ(eyes[1], glm::dvec3(camera_at(4).world_from_view[3]));
  static_cast<void>(walk.frame(6));
  ASSERT_EQ(eyes.size(), 3u);  // the frame before was just made
  EXPECT_EQ(eyes[2], glm::dvec3(camera_at(5).world_from_view[3]));
}

// Nobody looks back: no frame is spent on it.
TEST(FrameBefore, CostsNothingUnlessAsked) {
  int frames = 0;
  frame::Renderer renderer(gpu_context(), {.add = [&](graph::Graph& graph, const frame::FrameInputs& in) {
                             ++frames;
                             return frame::add_frame(graph, in);
                           }});
  Walk walk(renderer);
  static_cast<void>(walk.frame(2));
  EXPECT_EQ(frames, 1);
}

}  // namespace
}  // namespace velarium::test
