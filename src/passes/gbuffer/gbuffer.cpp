#include "passes/gbuffer/gbuffer.hpp"

#include "graph/context.hpp"
#include "upload/draw_scene.hpp"
#include "upload/materials.hpp"

#include <map>

namespace velarium::gbuffer {
namespace {

using graph::Access;

constexpr std::uint32_t kFragment[] =
#include "shaders/gbuffer.frag.inc"
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

gpu::RasterState raster_state(const Variant& variant) {
  return {.vertex_bindings = upload::vertex_bindings(),
          .vertex_attributes = upload::vertex_attributes(),
          .topology = upload::vulkan_topology(variant.topology),
          .color_formats = kColorFormats,
          .depth_format = kDepthFormat,
          .stencil = gpu::Stencil::replace,
          .fragment_constants = {variant.slots, variant.alpha_test ? 1u : 0u}};
}

bool is_unlit(const scene::Primitive& primitive, const scene::Material& material) {
  return material.unlit || primitive.vertices.normals.empty();
}

// Draws in order; state is set only where it changes.
void draw_all(graph::Context& c, const Inputs& in) {
  const auto& gpu_scene = *in.scene.gpu;
  const auto& scene = gpu_scene.scene();
  std::map<Variant, const gpu::Pipeline*> pipelines;
  const gpu::Pipeline* bound_pipeline = nullptr;
  std::int64_t bound_material = -1;
  int bound_streams = -1;
  for (const auto& draw : in.scene.draws.opaque) {
    const auto& primitive = scene.primitives[draw.primitive];
    const auto& material = upload::material_or_default(scene, primitive.material);
    const Variant variant{primitive.topology, upload::slot_mask(material),
                          material.alpha_mode == scene::AlphaMode::mask};
    const auto*& known = pipelines[variant];
    if (known == nullptr)
      known = &c.tools().pipelines.raster(upload::surface_vertex_shader(), kFragment, raster_state(variant));
    const auto& pipeline = *known;
    if (&pipeline != bound_pipeline) {
      c.bind(pipeline);
      c.set(pipeline, 0).buffer(0, in.scene.frame).buffer(1, in.scene.objects).bind();
      c.set(pipeline, 1).sampled(0, in.normal_lengths, gpu::kNearest).bind();
      bound_pipeline = &pipeline;
      bound_material = -1;
    }
    if (bound_material != draw.material) {
      c.bind_set(pipeline, 2, upload::material_bindings(c.tools().samplers, in.scene, draw.material));
      bound_material = draw.material;
    }
    if (const int streams = draw.deformed == scene::kNone ? 0 : 1; streams != bound_streams) {
      gpu_scene.bind_vertices(c.commands(), streams != 0);
      bound_streams = streams;
    }
    upload::set_facing(c.commands(), draw, upload::cull_mode(material));
    vkCmdSetStencilReference(c.commands(), VK_STENCIL_FACE_FRONT_AND_BACK,
                             is_unlit(primitive, material) ? shading::kClassUnlit : shading::kClassStandard);
    gpu_scene.draw(c.commands(), draw);
  }
}

}  // namespace

Outputs add(graph::Graph& graph, const Inputs& in) {
  auto& pass = graph.pass("gbuffer");
  const auto target = [&](const char* name, VkFormat format, Access access) {
    return pass.write(graph.image(name, {.format = format, .width = in.width, .height = in.height}), access);
  };
  const Outputs out{.rt0 = target("rt0", kColorFormats[0], Access::color_attachment),
                    .rt1 = target("rt1", kColorFormats[1], Access::color_attachment),
                    .rt2 = target("rt2", kColorFormats[2], Access::color_attachment),
                    .depth = target("depth", kDepthFormat, Access::depth_attachment),
                    .hdr = target("hdr", kColorFormats[3], Access::color_attachment)};
  pass.run([in, out](graph::Context& c) {
    c.begin_rendering({.colors = {{out.rt0, true}, {out.rt1, true}, {out.rt2, true}, {out.hdr, true}},
                       .depth = out.depth,
                       .clear_depth = true});
    draw_all(c, in);
    c.end_rendering();
  });
  return out;
}

}  // namespace velarium::gbuffer
