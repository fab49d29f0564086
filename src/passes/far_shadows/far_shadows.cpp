#include "passes/far_shadows/far_shadows.hpp"

#include "core/assert.hpp"
#include "passes/far_shadows/blur.hpp"

#include <cmath>

namespace velarium::far_shadows {
namespace {

namespace io {
using namespace shading;
#include "passes/far_shadows/far_blur_io.glsl"
}  // namespace io

using graph::Access;

constexpr std::uint32_t kBlur[] =
#include "shaders/passes/far_shadows/far_blur.comp.inc"
    ;
constexpr std::uint32_t kGroup = 8;

// Of the depth that moments are made of.
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

// Deviations after which the bell curve is cut off, at a twentieth of its height.
constexpr double kBlurEnd = 2.5;

io::BlurPush blur_push(float deviation) {
  io::BlurPush push{.radius = blur_radius(static_cast<double>(deviation))};
  VEL_ASSERT(push.radius < io::kMostTexels);
  float sum = 0.0f;
  for (std::int32_t i = -push.radius; i <= push.radius; ++i)
    sum += shading::blur_weight(static_cast<float>(i), deviation);
  for (std::int32_t i = 0; i <= push.radius; ++i)
    push.weights[i] = shading::blur_weight(static_cast<float>(i), deviation) / sum;
  return push;
}

graph::GraphImage add_blur(graph::Graph& graph, graph::GraphImage source, graph::GraphImage target, bool columns,
                           float deviation) {
  auto& pass = graph.pass(columns ? "far_shadows_columns" : "far_shadows_rows");
  pass.read(source, Access::compute_sample);
  const auto blurred = pass.write(target, Access::compute_storage);
  const io::BlurPush push = blur_push(deviation);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kBlur, gpu::Specialization().set(io::kColumns, columns));
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(io::blur_source, source).storage(io::blur_moments, blurred).bind();
    c.push(pipeline, push);
    const auto& size = c.image(blurred).desc();
    c.dispatch(size.width, size.height, kGroup, kGroup);
  });
  return blurred;
}

graph::GraphImage add_depth(graph::Graph& graph, const Inputs& in, graph::GraphImage target,
                            upload::CasterChoice casters, float slope_bias) {
  auto& pass = graph.pass("far_shadows");
  const auto depth = pass.write(target, Access::depth_attachment);
  pass.run([in, depth, casters, slope_bias](graph::Context& c) {
    c.begin_rendering({.depth = depth, .clear_depth = true});
    // Away from the sun, which is towards 0: depth is reversed.
    vkCmdSetDepthBias(c.commands(), 0.0f, 0.0f, -slope_bias);
    passes::draw_sun_map(c, in.tables, in.state.map(),
                         {.depth_format = c.image(depth).desc().format, .casters = casters});
    c.end_rendering();
  });
  return depth;
}

graph::GraphImage add_moments(graph::Graph& graph, const Inputs& in, graph::GraphImage moments) {
  const auto desc = graph.desc(moments);
  // No bias, as a plane's moments are its own.
  const auto depth = add_depth(
      graph, in,
      graph.image("depth", {.format = kDepthFormat, .width = desc.width, .height = desc.height, .array = true}),
      upload::CasterChoice::all, 0.0f);
  const auto rows = add_blur(graph, depth, graph.image("moments", desc), false, in.state.blur_deviation());
  return add_blur(graph, rows, moments, true, in.state.blur_deviation());
}

}  // namespace

int blur_radius(double deviation) {
  return static_cast<int>(std::ceil(kBlurEnd * deviation));
}

Reading add(graph::Graph& graph, const Inputs& in) {
  if (in.state.kind() == FarShadow::off) return {};
  const bool draws = in.first && in.state.is_stale();
  // What is drawn is drawn whole, so that a new image counts as initialised.
  auto image = graph.import("far_shadows.map", in.state.image(), true);
  if (draws && in.state.kind() == FarShadow::vsm) image = add_moments(graph, in, image);
  if (draws && in.state.kind() == FarShadow::static_map)
    image = add_depth(graph, in, image, upload::CasterChoice::static_only, in.settings.slope_bias);
  return {in.state.kind(), image, graph.upload("far_shadows.table", in.state.table())};
}

}  // namespace velarium::far_shadows
