#include "passes/forward/forward.hpp"

#include "upload/draw_scene.hpp"
#include "upload/io.hpp"
#include "upload/materials.hpp"

#include <map>

namespace velarium::forward {
namespace {

namespace own {
using namespace shading;
#include "passes/forward/forward_io.glsl"
}  // namespace own
namespace lists {
using namespace shading;
#include "passes/lighting/lighting_io.glsl"
}  // namespace lists

using graph::Access;

constexpr std::uint32_t kFragment[] =
#include "shaders/passes/forward/forward.frag.inc"
    ;

// What tells pipelines of this pass apart.
struct Variant {
  scene::Topology topology;
  std::uint32_t slots;  // upload::slot_mask()
  auto operator<=>(const Variant&) const = default;
};

gpu::RasterState raster_state(const graph::Context& c, const Inputs& in, const Variant& variant) {
  auto constants = passes::specialization(in.illumination);
  constants.set(upload::io::kSlots, variant.slots)
      .set(upload::io::kBakedNormalSpread, in.baked_normal_spread)
      .set(own::kLights, in.forward_lists.version != 0);
  return {.vertex_bindings = upload::vertex_bindings(),
          .vertex_attributes = upload::vertex_attributes(),
          .topology = upload::vulkan_topology(variant.topology),
          .color_formats = {c.image(in.hdr).desc().format},
          .depth_format = c.image(in.depth).desc().format,
          .depth_write = false,
          .blend = gpu::Blend::premultiplied,
          .fragment_constants = constants};
}

void bind_frame(graph::Context& c, const gpu::Pipeline& pipeline, const Inputs& in) {
  c.bind(pipeline);
  const auto& scene = in.illumination.scene;
  c.set(pipeline, 0)
      .buffer(upload::io::FrameBuffer, scene.frame_buffer)
      .buffer(upload::io::ObjectBuffer, scene.view.objects)
      .bind();
  auto shared = c.set(pipeline, 1);
  passes::bind(shared, in.illumination);
  shared.buffer(lists::ForwardListBuffer, in.forward_lists);
  shared.bind();
}

void draw_one(graph::Context& c, const passes::FrameScene& in, const upload::Draw& draw,
              const scene::Material& material) {
  upload::bind_vertices(c.commands(), in.tables, draw.deformed != scene::kNone);
  if (draw.first_sorted != scene::kNone) {
    vkCmdBindIndexBuffer(c.commands(), in.view.sorted_indices.vk(), 0, VK_INDEX_TYPE_UINT32);
    upload::set_facing(c.commands(), draw, upload::cull_mode(material));
    upload::draw_sorted(c.commands(), in.tables, draw);
    return;
  }
  // Without an order, the best guess is a closed body: it shows its far side through its near one.
  if (material.double_sided) {
    upload::set_facing(c.commands(), draw, VK_CULL_MODE_FRONT_BIT);
    upload::draw(c.commands(), in.tables, draw);
  }
  upload::set_facing(c.commands(), draw, VK_CULL_MODE_BACK_BIT);
  upload::draw(c.commands(), in.tables, draw);
}

void draw_all(graph::Context& c, const Inputs& in) {
  const auto& tables = in.illumination.scene.tables;
  const auto& scene = tables.gpu->scene();
  std::map<Variant, const gpu::Pipeline*> pipelines;
  const gpu::Pipeline* bound = nullptr;
  for (const auto& draw : in.illumination.scene.view.draws.blended) {
    const auto& primitive = scene.primitives[draw.primitive];
    const auto& material = upload::material_or_default(scene, primitive.material);
    const Variant variant{primitive.topology, upload::slot_mask(material)};
    const auto*& known = pipelines[variant];
    if (known == nullptr)
      known = &c.tools().pipelines.raster(upload::surface_vertex_shader(), kFragment, raster_state(c, in, variant));
    const auto& pipeline = *known;
    if (&pipeline != bound) bind_frame(c, pipeline, in);
    bound = &pipeline;
    c.bind_set(pipeline, 2,
               upload::material_bindings(c.tools().samplers, *tables.gpu, tables.texture_quality, draw.material));
    vkCmdSetStencilReference(c.commands(), VK_STENCIL_FACE_FRONT_AND_BACK, 0);
    draw_one(c, in.illumination.scene, draw, material);
  }
}

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in) {
  if (in.illumination.scene.view.draws.blended.empty()) return in.hdr;
  auto& pass = graph.pass("forward");
  pass.read(in.depth, Access::depth_test);
  passes::declare(pass, in.illumination, Access::fragment_sample);
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
