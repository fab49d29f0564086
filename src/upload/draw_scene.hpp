#pragma once

#include "gpu/pipeline_library.hpp"
#include "upload/gpu_scene.hpp"

#include <functional>

namespace velarium::upload {

[[nodiscard]] VkPrimitiveTopology vulkan_topology(scene::Topology topology);

[[nodiscard]] gpu::Spirv surface_vertex_shader();

// Cull mode and front face for a draw: mirrored instances are wound the other way, double-sided ones are not culled.
void set_facing(VkCommandBuffer commands, const Draw& draw, VkCullModeFlags cull);

// The cull mode that a material asks for: none where it is double-sided, else back faces.
[[nodiscard]] VkCullModeFlags cull_mode(const scene::Material& material);

}  // namespace velarium::upload
