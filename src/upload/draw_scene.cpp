#include "upload/draw_scene.hpp"

namespace velarium::upload {
namespace {

constexpr std::uint32_t kSurfaceVertex[] =
#include "shaders/surface.vert.inc"
    ;

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

}  // namespace velarium::upload
