#include "passes/normal_variance/normal_variance.hpp"

#include "graph/context.hpp"

#include <cmath>

namespace velarium::normal_variance {
namespace {

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/normal_variance.comp.inc"
    ;

struct Push {
  float share;  // of the variance between the taps: what one frame of the picture should see of it
  std::uint32_t dim_dielectrics;
};

// Frames that are averaged look at finer parts of a pixel each: by the level that textures are sharpened.
float share_of_a_frame(const upload::SceneTables& scene, const Settings& settings) {
  return settings.strength * shading::kScreenShare * std::exp2(2.0f * scene.texture_lod_bias);
}

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in, const Settings& settings) {
  if (!settings.screen) return in.rt2;
  auto& pass = graph.pass("normal_variance");
  pass.read(in.rt0, Access::compute_sample).read(in.depth, Access::compute_sample);
  const auto rt2 = pass.write(in.rt2, Access::compute_storage);
  const Push push{share_of_a_frame(in.scene, settings), settings.dim_dielectrics ? 1u : 0u};
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kShader);
    c.bind(pipeline);
    c.set(pipeline, 0)
        .buffer(0, in.scene.frame)
        .sampled(1, in.rt0, gpu::kNearest)
        .sampled(2, in.depth)
        .storage(3, rt2)
        .bind();
    c.push(pipeline, push);
    const auto& size = c.image(rt2).desc();
    c.dispatch(size.width, size.height, 8, 8);
  });
  return rt2;
}

}  // namespace velarium::normal_variance
