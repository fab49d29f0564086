#include "passes/sun_mask/sun_mask.hpp"

#include "passes/shading_inputs.hpp"

namespace velarium::sun_mask {
namespace {

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/sun_mask.comp.inc"
    ;

// One channel that every device can store to.
constexpr VkFormat kFormat = VK_FORMAT_R32_SFLOAT;
constexpr std::uint32_t kGroup = 8;

constexpr std::size_t kTapsConstant = 13;  // upload/shadow_taps.glsl
constexpr std::size_t kFarConstant = 15;   // upload/far_shadows.glsl

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in, const Settings& settings) {
  auto& pass = graph.pass("sun_mask");
  for (const auto image : {in.rt0, in.depth, in.cascades}) pass.read(image, Access::compute_sample);
  if (in.far.image.version != 0) pass.read(in.far.image, Access::compute_sample);
  const auto size = graph.desc(in.depth);
  const auto occlusion =
      pass.write(graph.image("occlusion", {.format = kFormat, .width = size.width, .height = size.height}),
                 Access::compute_storage);
  gpu::Specialization constants(passes::kSharedConstants);
  constants[kTapsConstant] = static_cast<std::uint32_t>(settings.sun_shadows.taps);
  passes::set_contact_shadows(settings.contact_shadows, constants);
  constants[kFarConstant] = static_cast<std::uint32_t>(in.far.kind);
  pass.run([in, occlusion, constants, width = size.width, height = size.height](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kShader, constants);
    c.bind(pipeline);
    c.set(pipeline, 0)
        .buffer(0, in.scene.frame)
        .sampled(1, in.rt0, gpu::kNearest)
        .sampled(4, in.depth)
        .storage(6, occlusion)
        .bind();
    auto set = c.set(pipeline, 1);
    set.sampled(9, in.cascades).sampled(10, in.cascades, {.compare = true}).buffer(11, in.scene.sun_shadows);
    passes::bind(set, in.far, in.cascades);
    set.bind();
    c.dispatch(width, height, kGroup, kGroup);
  });
  return occlusion;
}

}  // namespace velarium::sun_mask
