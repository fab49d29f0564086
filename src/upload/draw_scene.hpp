#pragma once

#include "gpu/pipeline_library.hpp"
#include "upload/tables.hpp"

#include <functional>

namespace velarium::upload {

[[nodiscard]] VkPrimitiveTopology vulkan_topology(scene::Topology topology);

[[nodiscard]] gpu::Spirv surface_vertex_shader();

// Cull mode and front face for a draw: mirrored instances are wound the other way, double-sided ones are not culled.
void set_facing(VkCommandBuffer commands, const Draw& draw, VkCullModeFlags cull);

// The cull mode that a material asks for: none where it is double-sided, else back faces.
[[nodiscard]] VkCullModeFlags cull_mode(const scene::Material& material);

// Binds the vertex streams that a draw reads, the scene's or the deformed ones of the snapshot, and the scene's
// indices.
void bind_vertices(VkCommandBuffer commands, const Tables& tables, bool deformed);

void draw(VkCommandBuffer commands, const Tables& tables, const Draw& draw);

// Of a draw whose triangles are sorted, with View::sorted_indices bound in place of the scene's.
void draw_sorted(VkCommandBuffer commands, const Tables& tables, const Draw& draw);

}  // namespace velarium::upload
