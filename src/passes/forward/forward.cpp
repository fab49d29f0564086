#include "passes/forward/forward.hpp"

#include "graph/context.hpp"
#include "upload/draw_scene.hpp"
#include "upload/materials.hpp"

namespace velarium::forward {
namespace {

using graph::Access;

constexpr std::uint32_t kFragment[] =
#include "shaders/forward.frag.inc"
    ;

gpu::RasterState raster_state(const graph::Context& c, const Inputs& in, scene::Topology topology,
                              std::uint32_t slots) {
  auto constants = in.shading_constants;
  constants[0] = slots;
  constants.push_back(in.forward_lists.version != 0 ? 1u : 0u);
  return {.vertex_bindings = upload::vertex_bindings(),
          .vertex_attributes = upload::vertex_attributes(),
          .topology = upload::vulkan_topology(topology),
          .color_formats = {c.image(in.hdr).desc().format},
          .depth_format = c.image(in.depth).desc().format,
          .depth_write = false,
          .blend = gpu::Blend::premultiplied,
          .fragment_constants = constants};
}

void bind_frame(graph::Context& c, const gpu::Pipeline& pipeline, const Inputs& in) {
  c.bind(pipeline);
  c.set(pipeline, 0).buffer(0, in.scene.frame).buffer(1, in.scene.objects).bind();
  auto set = c.set(pipeline, 1);
  set.sampled(0, in.environment).sampled(1, in.brdf_table).buffer(2, in.scene.lights).sampled(4, in.irradiance);
  if (in.forward_lists.version != 0)
    set.buffer(3, in.forward_lists);
  else
    set.buffer(3, in.scene.lights);  // bound, never read
  set.bind();
}

// A double-sided surface shows its far side through its near one: back faces first.
void draw_sides(graph::Context& c, const Inputs& in, const upload::Draw& draw, bool double_sided) {
  if (double_sided) {
    upload::set_facing(c.commands(), draw, VK_CULL_MODE_FRONT_BIT);
    in.scene.gpu->draw(c.commands(), draw);
  }
  upload::set_facing(c.commands(), draw, VK_CULL_MODE_BACK_BIT);
  in.scene.gpu->draw(c.commands(), draw);
}

void draw_all(graph::Context& c, const Inputs& in) {
  const auto& scene = in.scene.gpu->scene();
  const gpu::Pipeline* bound = nullptr;
  for (const auto& draw : in.scene.draws.blended) {
    const auto& primitive = scene.primitives[draw.primitive];
    const auto& material = upload::material_or_default(scene, primitive.material);
    const auto& pipeline =
        c.tools().pipelines.raster(upload::surface_vertex_shader(), kFragment,
                                   raster_state(c, in, primitive.topology, upload::slot_mask(material)));
    if (&pipeline != bound) bind_frame(c, pipeline, in);
    bound = &pipeline;
    c.bind_set(pipeline, 2, upload::material_bindings(c.tools().samplers, in.scene, draw.material));
    in.scene.gpu->bind_vertices(c.commands(), draw.deformed != scene::kNone);
    vkCmdSetStencilReference(c.commands(), VK_STENCIL_FACE_FRONT_AND_BACK, 0);
    draw_sides(c, in, draw, material.double_sided);
  }
}

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in) {
  if (in.scene.draws.blended.empty()) return in.hdr;
  auto& pass = graph.pass("forward");
  pass.read(in.depth, Access::depth_test);
  if (in.forward_lists.version != 0) pass.read(in.forward_lists, Access::fragment_sample);
  const auto hdr = pass.write(in.hdr, Access::color_attachment);
  pass.run([in, hdr](graph::Context& c) {
    c.begin_rendering({.colors = {{hdr}}, .depth = in.depth, .depth_writable = false});
    draw_all(c, in);
    c.end_rendering();
  });
  return hdr;
}

}  // namespace velarium::forward
