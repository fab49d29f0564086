#include "passes/gbuffer/gbuffer.hpp"

#include "graph/context.hpp"
#include "upload/draw_scene.hpp"
#include "upload/io.hpp"
#include "upload/materials.hpp"

#include <map>

namespace velarium::gbuffer {
namespace {

namespace own {
using namespace shading;
#include "passes/gbuffer/gbuffer_out_io.glsl"
}  // namespace own

using graph::Access;

constexpr std::uint32_t kFragment[] =
#include "shaders/passes/gbuffer/gbuffer.frag.inc"
    ;

constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT_S8_UINT;
const std::vector<VkFormat> kColorFormats{VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R8G8B8A8_UNORM,
                                          VK_FORMAT_R16G16B16A16_SFLOAT};

// What tells pipelines of this pass apart.
struct Variant {
  scene::Topology topology;
  std::uint32_t slots;  // upload::slot_mask()
  bool alpha_test;
  auto operator<=>(const Variant&) const = default;
};

gpu::RasterState raster_state(const Variant& variant, bool baked_normal_spread) {
  gpu::Specialization constants;
  constants.set(upload::io::kSlots, variant.slots)
      .set(upload::io::kBakedNormalSpread, baked_normal_spread)
      .set(own::kAlphaTest, variant.alpha_test);
  return {.vertex_bindings = upload::vertex_bindings(),
          .vertex_attributes = upload::vertex_attributes(),
          .topology = upload::vulkan_topology(variant.topology),
          .color_formats = kColorFormats,
          .depth_format = kDepthFormat,
          .stencil = gpu::Stencil::replace,
          .fragment_constants = constants};
}

bool is_unlit(const scene::Primitive& primitive, const scene::Material& material) {
  return material.unlit || primitive.vertices.normals.empty();
}

// Draws in order; state is set only where it changes.
void draw_all(graph::Context& c, const Inputs& in) {
  const auto& tables = in.scene.tables;
  const auto& gpu_scene = *tables.gpu;
  const auto& scene = gpu_scene.scene();
  std::map<Variant, const gpu::Pipeline*> pipelines;
  const gpu::Pipeline* bound_pipeline = nullptr;
  std::int64_t bound_material = -1;
  int bound_streams = -1;
  for (const auto& draw : in.scene.view.draws.opaque) {
    const auto& primitive = scene.primitives[draw.primitive];
    const auto& material = upload::material_or_default(scene, primitive.material);
    const Variant variant{primitive.topology, upload::slot_mask(material),
                          material.alpha_mode == scene::AlphaMode::mask};
    const auto*& known = pipelines[variant];
    if (known == nullptr)
      known = &c.tools().pipelines.raster(upload::surface_vertex_shader(), kFragment,
                                          raster_state(variant, in.baked_normal_spread));
    const auto& pipeline = *known;
    if (&pipeline != bound_pipeline) {
      c.bind(pipeline);
      c.set(pipeline, 0)
          .buffer(upload::io::FrameBuffer, in.scene.frame_buffer)
          .buffer(upload::io::ObjectBuffer, in.scene.view.objects)
          .bind();
      c.set(pipeline, 1).sampled(own::normal_lengths, &in.normal_lengths).bind();
      bound_pipeline = &pipeline;
      bound_material = -1;
    }
    if (bound_material != draw.material) {
      c.bind_set(pipeline, 2,
                 upload::material_bindings(c.tools().samplers, gpu_scene, tables.texture_quality, draw.material));
      bound_material = draw.material;
    }
    if (const int streams = draw.deformed == scene::kNone ? 0 : 1; streams != bound_streams) {
      upload::bind_vertices(c.commands(), tables, streams != 0);
      bound_streams = streams;
    }
    upload::set_facing(c.commands(), draw, upload::cull_mode(material));
    vkCmdSetStencilReference(c.commands(), VK_STENCIL_FACE_FRONT_AND_BACK,
                             is_unlit(primitive, material) ? shading::kClassUnlit : shading::kClassStandard);
    upload::draw(c.commands(), tables, draw);
  }
}

}  // namespace

Outputs add(graph::Graph& graph, const Inputs& in) {
  auto& pass = graph.pass("gbuffer");
  const auto target = [&](const char* name, VkFormat format, Access access) {
    return pass.write(
        graph.image(name, {.format = format, .width = in.scene.view.size.x, .height = in.scene.view.size.y}), access);
  };
  const Outputs out{.gbuffer = {.normal = target("normal", kColorFormats[0], Access::color_attachment),
                                .albedo = target("albedo", kColorFormats[1], Access::color_attachment),
                                .specular = target("specular", kColorFormats[2], Access::color_attachment),
                                .depth = target("depth", kDepthFormat, Access::depth_attachment)},
                    .hdr = target("hdr", kColorFormats[3], Access::color_attachment)};
  pass.run([in, out](graph::Context& c) {
    const auto& [normal, albedo, specular, depth] = out.gbuffer;
    c.begin_rendering({.colors = {{normal, true}, {albedo, true}, {specular, true}, {out.hdr, true}},
                       .depth = depth,
                       .clear_depth = true});
    draw_all(c, in);
    c.end_rendering();
  });
  return out;
}

}  // namespace velarium::gbuffer
