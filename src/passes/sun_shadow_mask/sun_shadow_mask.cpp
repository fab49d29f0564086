#include "passes/sun_shadow_mask/sun_shadow_mask.hpp"

#include "upload/io.hpp"

namespace velarium::sun_shadow_mask {
namespace {

namespace own {
using namespace shading;
#include "passes/sun_shadow_mask/sun_shadow_mask_out_io.glsl"
}  // namespace own

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/passes/sun_shadow_mask/sun_shadow_mask.comp.inc"
    ;

// One channel that every device can store to.
constexpr VkFormat kFormat = VK_FORMAT_R32_SFLOAT;
constexpr std::uint32_t kGroup = 8;

}  // namespace

Reading add(graph::Graph& graph, const Inputs& in) {
  auto& pass = graph.pass("sun_shadow_mask");
  for (const auto image : {in.normal, in.depth}) pass.read(image, Access::compute_sample);
  passes::declare(pass, in.illumination, Access::compute_sample);
  const auto size = graph.desc(in.depth);
  const auto occlusion =
      pass.write(graph.image("occlusion", {.format = kFormat, .width = size.width, .height = size.height}),
                 Access::compute_storage);
  pass.run([in, occlusion, width = size.width, height = size.height](graph::Context& c) {
    auto constants = passes::specialization(in.illumination);
    specialize(constants, in.contact);
    const auto& pipeline = c.tools().pipelines.compute(kShader, constants);
    c.bind(pipeline);
    c.set(pipeline, 0)
        .buffer(upload::io::FrameBuffer, in.illumination.scene.frame_buffer)
        .sampled(gbuffer::io::gbuffer_normal, in.normal)
        .sampled(gbuffer::io::gbuffer_depth, in.depth)
        .storage(own::occlusion_out, occlusion)
        .bind();
    auto shared = c.set(pipeline, 1);
    passes::bind(shared, in.illumination);
    contact_shadows::bind(shared, in.contact);
    shared.bind();
    c.dispatch(width, height, kGroup, kGroup);
  });
  return {occlusion};
}

}  // namespace velarium::sun_shadow_mask
