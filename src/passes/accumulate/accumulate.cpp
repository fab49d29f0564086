#include "passes/accumulate/accumulate.hpp"

#include "graph/context.hpp"

namespace velarium::accumulate {
namespace {

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/accumulate.comp.inc"
    ;

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in) {
  auto& pass = graph.pass("accumulate");
  pass.read(in.hdr, Access::compute_sample);
  const auto sum = pass.write(in.sum, Access::compute_storage);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kShader, {in.first ? 1u : 0u});
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(0, in.hdr).storage(1, sum).bind();
    const auto& size = c.image(sum).desc();
    c.dispatch(size.width, size.height, 8, 8);
  });
  return sum;
}

}  // namespace velarium::accumulate
