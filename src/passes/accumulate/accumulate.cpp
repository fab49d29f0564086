#include "passes/accumulate/accumulate.hpp"

#include "passes/io.hpp"

namespace velarium::accumulate {
namespace {

namespace io {
using namespace shading;
#include "passes/accumulate/accumulate_io.glsl"
}  // namespace io

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/passes/accumulate/accumulate.comp.inc"
    ;

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in) {
  auto& pass = graph.pass("accumulate");
  pass.read(in.hdr, Access::compute_sample);
  const auto sum = pass.write(in.sum, Access::compute_storage);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kShader, gpu::Specialization().set(io::kFirst, in.first));
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(io::hdr, in.hdr).storage(io::sum, sum).bind();
    const auto& size = c.image(sum).desc();
    c.dispatch(size.width, size.height, 8, 8);
  });
  return sum;
}

}  // namespace velarium::accumulate
