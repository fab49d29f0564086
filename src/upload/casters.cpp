#include "upload/casters.hpp"

#include "upload/draw_scene.hpp"
#include "upload/io.hpp"
#include "upload/materials.hpp"
#include "upload/tables.hpp"

#include <algorithm>
#include <tuple>

namespace velarium::upload {
namespace {

#include "upload/caster_io.glsl"

constexpr std::uint32_t kVertex[] =
#include "shaders/upload/caster.vert.inc"
    ;
constexpr std::uint32_t kTexturedVertex[] =
#include "shaders/upload/caster_textured.vert.inc"
    ;
constexpr std::uint32_t kCutoutFragment[] =
#include "shaders/upload/caster_cutout.frag.inc"
    ;

constexpr std::uint32_t kTranslucentFragment[] =
#include "shaders/upload/caster_translucent.frag.inc"
    ;

CasterKind kind_of(scene::AlphaMode mode) {
  switch (mode) {
    case scene::AlphaMode::opaque:
      return CasterKind::opaque;
    case scene::AlphaMode::mask:
      return CasterKind::cutout;
    case scene::AlphaMode::blend:
      return CasterKind::translucent;
  }
  return CasterKind::opaque;
}

bool is_chosen(const Caster& caster, CasterChoice choice) {
  return choice == CasterChoice::all || !caster.dynamic;
}

auto state_of(const Draw& draw) {
  return std::tuple(draw.primitive, draw.deformed, draw.material, draw.mirrored);
}

gpu::RasterState raster_state(const CasterView& view, const scene::Primitive& primitive,
                              const scene::Material& material, CasterKind kind) {
  gpu::RasterState state = view.state;
  state.topology = vulkan_topology(primitive.topology);
  state.vertex_bindings = vertex_bindings();
  state.vertex_attributes = vertex_attributes();
  // Only what the vertex shader reads: the rest would be fetched for nothing.
  std::erase_if(state.vertex_attributes, [&](const gpu::VertexAttribute& attribute) {
    return attribute.location == 1 || attribute.location == 2 || (kind == CasterKind::opaque && attribute.location > 0);
  });
  if (kind != CasterKind::opaque) state.fragment_constants.set(io::kSlots, slot_mask(material) & 1u << kSlotBaseColor);
  return state;
}

const gpu::Pipeline& pipeline_of(gpu::GpuContext& tools, const CasterView& view, const scene::Primitive& primitive,
                                 const scene::Material& material, CasterKind kind) {
  const auto state = raster_state(view, primitive, material, kind);
  switch (kind) {
    case CasterKind::opaque:
      return tools.pipelines.raster(kVertex, {}, state);
    case CasterKind::cutout:
      return tools.pipelines.raster(kTexturedVertex, kCutoutFragment, state);
    case CasterKind::translucent:
      break;
  }
  return tools.pipelines.raster(kTexturedVertex, kTranslucentFragment, state);
}

// Binds descriptor sets to one command buffer.
struct Binder {
  gpu::GpuContext& tools;
  VkCommandBuffer commands;
  void set(const gpu::Pipeline& pipeline, std::uint32_t index, const gpu::Bindings& bindings) const {
    const VkDescriptorSet descriptors = tools.descriptors.make(pipeline, index, bindings);
    vkCmdBindDescriptorSets(commands, pipeline.bind_point(), pipeline.layout(), index, 1, &descriptors, 0, nullptr);
  }
};

}  // namespace

CasterTable make_casters(const scene::Scene& scene, const scene::SceneSnapshot& snapshot, const glm::dvec3& origin) {
  const auto dynamic = scene::dynamic_nodes(scene);
  std::vector<std::pair<Caster, const scene::Instance*>> sorted;
  for (const auto& instance : snapshot.instances) {
    const auto& primitive = scene.primitives[instance.primitive];
    if (instance.bounds.empty() || primitive.topology != scene::Topology::triangles) continue;
    const auto& material = material_or_default(scene, primitive.material);
    sorted.push_back({{instance.bounds,
                       {.primitive = instance.primitive,
                        .deformed = instance.deformed,
                        .material = material_index(scene, primitive.material),
                        .mirrored = instance.mirrored},
                       kind_of(material.alpha_mode),
                       instance.deformed != scene::kNone || dynamic[instance.node],
                       primitive.indices,
                       positions_of(scene, snapshot, instance)},
                      &instance});
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first.kind, state_of(a.first.draw)) < std::tuple(b.first.kind, state_of(b.first.draw));
  });
  CasterTable table;
  for (auto& [caster, instance] : sorted) {
    caster.draw.first_object = static_cast<std::uint32_t>(table.objects.size());
    table.casters.push_back(caster);
    table.objects.push_back(object_data(*instance, origin));
  }
  return table;
}

bool has_translucent(const CasterTable& table) {
  return !table.casters.empty() && table.casters.back().kind == CasterKind::translucent;
}

bool has_static(const CasterTable& table) {
  return std::any_of(table.casters.begin(), table.casters.end(), [](const Caster& caster) { return !caster.dynamic; });
}

scene::WorldAabb bounds_of(const CasterTable& table, CasterChoice choice) {
  scene::WorldAabb bounds;
  for (const auto& caster : table.casters)
    if (is_chosen(caster, choice)) bounds.add(caster.bounds);
  return bounds;
}

std::vector<Draw> visible_casters(const CasterTable& table, CasterKind kind, std::span<const glm::dvec4> planes,
                                  CasterChoice choice) {
  std::vector<Draw> draws;
  for (const auto& caster : table.casters) {
    if (caster.kind != kind || !is_chosen(caster, choice) || !overlaps(planes, caster.bounds)) continue;
    const bool joins = !draws.empty() && state_of(draws.back()) == state_of(caster.draw) &&
                       draws.back().first_object + draws.back().object_count == caster.draw.first_object;
    if (joins)
      ++draws.back().object_count;
    else
      draws.push_back(caster.draw);
  }
  return draws;
}

gpu::RasterState translucency_state(VkFormat depth, bool depth_clamp) {
  return {.color_formats = {kTranslucencyFormat},
          .depth_format = depth,
          .depth_write = false,
          .depth_clamp = depth_clamp,
          .blend = gpu::Blend::translucency};
}

void draw_casters(gpu::GpuContext& tools, VkCommandBuffer commands, const Tables& tables, std::span<const Draw> draws,
                  CasterKind kind, const CasterView& view) {
  const auto& scene = tables.gpu->scene();
  const Binder bind{tools, commands};
  const gpu::Pipeline* bound = nullptr;
  for (const auto& draw : draws) {
    const auto& primitive = scene.primitives[draw.primitive];
    const auto& material = material_or_default(scene, primitive.material);
    const auto& pipeline = pipeline_of(tools, view, primitive, material, kind);
    if (&pipeline != bound) {
      vkCmdBindPipeline(commands, pipeline.bind_point(), pipeline.vk());
      bind.set(pipeline, io::ObjectBuffer.set, gpu::Bindings().buffer(io::ObjectBuffer, tables.caster_objects));
      const CasterPush push{view.clip_from_world};
      vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                         sizeof(push), &push);
      bound = &pipeline;
    }
    if (kind != CasterKind::opaque)
      bind.set(pipeline, io::MaterialBuffer.set,
               material_bindings(tools.samplers, *tables.gpu, tables.texture_quality, draw.material));
    bind_vertices(commands, tables, draw.deformed != scene::kNone);
    set_facing(commands, draw, material.double_sided ? VkCullModeFlags{VK_CULL_MODE_NONE} : view.cull);
    upload::draw(commands, tables, draw);
  }
}

}  // namespace velarium::upload
