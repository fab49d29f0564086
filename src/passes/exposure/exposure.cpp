#include "passes/exposure/exposure.hpp"

#include "core/assert.hpp"
#include "passes/io.hpp"

#include <cmath>

namespace velarium::exposure {
namespace {

namespace io {
using namespace shading;
#include "passes/exposure/exposure_io.glsl"
}  // namespace io

using graph::Access;

constexpr std::uint32_t kPartialShader[] =
#include "shaders/passes/exposure/exposure_partial.comp.inc"
    ;
constexpr std::uint32_t kResolveShader[] =
#include "shaders/passes/exposure/exposure_resolve.comp.inc"
    ;

// Fixed, and so is the order of the sums: every device and driver adds the same numbers in the same order.
constexpr std::uint32_t kPartialCount = 64;

struct Partial {
  float log2_sum, weight;
};

graph::GraphBuffer add_partial(graph::Graph& graph, const Inputs& in) {
  auto& pass = graph.pass("exposure_partial");
  pass.read(in.sum, Access::compute_sample);
  const auto partial = pass.write(graph.buffer("sums", kPartialCount * sizeof(Partial)), Access::compute_storage);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kPartialShader);
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(io::frame_sum, in.sum).buffer(io::Partials, partial).bind();
    c.push(pipeline, io::PartialPush{1.0f / static_cast<float>(in.frame_count)});
    c.dispatch(kPartialCount, 1, 1, 1);
  });
  return partial;
}

graph::GraphBuffer add_resolve(graph::Graph& graph, graph::GraphBuffer partial, float scale) {
  auto& pass = graph.pass("exposure");
  pass.read(partial, Access::compute_sample);
  const auto exposure = pass.write(graph.buffer("multiplier", sizeof(float)), Access::compute_storage);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kResolveShader);
    c.bind(pipeline);
    c.set(pipeline, 0).buffer(io::Partials, partial).buffer(io::Exposure, exposure).bind();
    c.push(pipeline, io::ResolvePush{scale});
    c.dispatch(1, 1, 1, 1);
  });
  return exposure;
}

graph::GraphBuffer add_constant(graph::Graph& graph, float value) {
  auto& pass = graph.pass("exposure");
  const auto exposure = pass.write(graph.buffer("multiplier", sizeof(float)), Access::transfer_write);
  pass.run(
      [=](graph::Context& c) { vkCmdUpdateBuffer(c.commands(), c.buffer(exposure).vk(), 0, sizeof value, &value); });
  return exposure;
}

}  // namespace

float manual_exposure(const Settings::display_settings& settings) {
  VEL_ASSERT(settings.exposure_mode != ExposureMode::automatic);
  const float base =
      settings.exposure_mode == ExposureMode::ev100 ? shading::exposure_from_ev100(settings.ev100) : 1.0f;
  return base * std::exp2(settings.exposure);
}

Outputs add(graph::Graph& graph, const Inputs& in, const Settings::display_settings& settings) {
  if (settings.exposure_mode != ExposureMode::automatic) return {add_constant(graph, manual_exposure(settings))};
  return {add_resolve(graph, add_partial(graph, in), std::exp2(settings.exposure))};
}

}  // namespace velarium::exposure
