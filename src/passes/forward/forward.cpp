#include "passes/forward/forward.hpp"

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
  auto constants = passes::shading_constants(in.shading);
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
  const auto& scene = in.shading.scene;
  c.set(pipeline, 0).buffer(0, scene.frame).buffer(1, scene.objects).bind();
  auto shared = c.set(pipeline, 1);
  passes::bind(shared, in.shading);
  if (in.forward_lists.version != 0)
    shared.buffer(3, in.forward_lists);
  else
    shared.buffer(3, scene.lights);  // bound, never read
  shared.bind();
}

void draw_one(graph::Context& c, const upload::SceneTables& tables, const upload::Draw& draw,
              const scene::Material& material) {
  const auto& scene = *tables.gpu;
  scene.bind_vertices(c.commands(), draw.deformed != scene::kNone);
  if (draw.first_sorted != scene::kNone) {
    vkCmdBindIndexBuffer(c.commands(), tables.sorted_indices.vk(), 0, VK_INDEX_TYPE_UINT32);
    upload::set_facing(c.commands(), draw, upload::cull_mode(material));
    scene.draw_sorted(c.commands(), draw);
    return;
  }
  // Without an order, the best guess is a closed body: it shows its far side through its near one.
  if (material.double_sided) {
    upload::set_facing(c.commands(), draw, VK_CULL_MODE_FRONT_BIT);
    scene.draw(c.commands(), draw);
  }
  upload::set_facing(c.commands(), draw, VK_CULL_MODE_BACK_BIT);
  scene.draw(c.commands(), draw);
}

void draw_all(graph::Context& c, const Inputs& in) {
  const auto& tables = in.shading.scene;
  const auto& scene = tables.gpu->scene();
  const gpu::Pipeline* bound = nullptr;
  for (const auto& draw : tables.draws.blended) {
    const auto& primitive = scene.primitives[draw.primitive];
    const auto& material = upload::material_or_default(scene, primitive.material);
    const auto& pipeline =
        c.tools().pipelines.raster(upload::surface_vertex_shader(), kFragment,
                                   raster_state(c, in, primitive.topology, upload::slot_mask(material)));
    if (&pipeline != bound) bind_frame(c, pipeline, in);
    bound = &pipeline;
    c.bind_set(pipeline, 2, upload::material_bindings(c.tools().samplers, tables, draw.material));
    vkCmdSetStencilReference(c.commands(), VK_STENCIL_FACE_FRONT_AND_BACK, 0);
    draw_one(c, tables, draw, material);
  }
}

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in) {
  if (in.shading.scene.draws.blended.empty()) return in.hdr;
  auto& pass = graph.pass("forward");
  pass.read(in.depth, Access::depth_test);
  passes::read(pass, in.shading, Access::fragment_sample);
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
