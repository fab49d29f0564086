#include "passes/specular_aa/specular_aa.hpp"

#include "upload/io.hpp"

#include <cmath>

namespace velarium::specular_aa {
namespace {

namespace io {
using namespace shading;
#include "passes/specular_aa/specular_aa_io.glsl"
}  // namespace io

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/passes/specular_aa/specular_aa.comp.inc"
    ;

// Frames that are averaged look at finer parts of a pixel each: by the level that textures are sharpened.
float share_of_a_frame(const upload::Tables& tables, const Settings& settings) {
  return settings.strength * shading::kScreenShare * std::exp2(2.0f * tables.texture_quality.lod_bias);
}

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in, const Settings& settings) {
  if (!settings.screen) return in.gbuffer.specular;
  auto& pass = graph.pass("specular_aa");
  pass.read(in.gbuffer.normal, Access::compute_sample).read(in.gbuffer.depth, Access::compute_sample);
  const auto specular = pass.write(in.gbuffer.specular, Access::compute_storage);
  const io::SpecularAaPush push{share_of_a_frame(in.scene.tables, settings), settings.dim_dielectrics ? 1u : 0u};
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kShader);
    c.bind(pipeline);
    c.set(pipeline, 0)
        .buffer(upload::io::FrameBuffer, in.scene.frame_buffer)
        .sampled(gbuffer::io::gbuffer_normal, in.gbuffer.normal)
        .sampled(gbuffer::io::gbuffer_depth, in.gbuffer.depth)
        .storage(io::specular, specular)
        .bind();
    c.push(pipeline, push);
    const auto& size = c.image(specular).desc();
    c.dispatch(size.width, size.height, 8, 8);
  });
  return specular;
}

}  // namespace velarium::specular_aa
