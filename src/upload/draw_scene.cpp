#include "upload/draw_scene.hpp"

#include "upload/vertices.hpp"

#include <array>

namespace velarium::upload {
namespace {

constexpr std::uint32_t kSurfaceVertex[] =
#include "shaders/upload/surface.vert.inc"
    ;

std::int32_t first_vertex(const Tables& tables, const Draw& draw) {
  return draw.deformed == scene::kNone ? tables.gpu->range(draw.primitive).first_vertex
                                       : tables.deformed.first[static_cast<std::size_t>(draw.deformed)];
}

}  // namespace

VkPrimitiveTopology vulkan_topology(scene::Topology topology) {
  switch (topology) {
    case scene::Topology::points:
      return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case scene::Topology::lines:
      return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    case scene::Topology::triangles:
      return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  }
  return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

gpu::Spirv surface_vertex_shader() {
  return kSurfaceVertex;
}

void set_facing(VkCommandBuffer commands, const Draw& draw, VkCullModeFlags cull) {
  vkCmdSetCullMode(commands, cull);
  vkCmdSetFrontFace(commands, draw.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

VkCullModeFlags cull_mode(const scene::Material& material) {
  return material.double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
}

void bind_vertices(VkCommandBuffer commands, const Tables& tables, bool deformed) {
  const auto& streams = deformed ? tables.deformed.vertices : tables.gpu->vertices();
  const std::array buffers{streams.positions.vk(), streams.attributes.vk()};
  const std::array<VkDeviceSize, 2> offsets{0, 0};
  vkCmdBindVertexBuffers(commands, kPositionStream, 2, buffers.data(), offsets.data());
  vkCmdBindIndexBuffer(commands, tables.gpu->indices().vk(), 0, VK_INDEX_TYPE_UINT32);
}

void draw(VkCommandBuffer commands, const Tables& tables, const Draw& draw) {
  const auto& range = tables.gpu->range(draw.primitive);
  vkCmdDrawIndexed(commands, range.index_count, draw.object_count, range.first_index, first_vertex(tables, draw),
                   draw.first_object);
}

void draw_sorted(VkCommandBuffer commands, const Tables& tables, const Draw& draw) {
  vkCmdDrawIndexed(commands, tables.gpu->range(draw.primitive).index_count, 1,
                   static_cast<std::uint32_t>(draw.first_sorted), first_vertex(tables, draw), draw.first_object);
}

}  // namespace velarium::upload
