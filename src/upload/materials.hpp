#pragma once

#include "scene/scene.hpp"
#include "upload/gpu_structs.hpp"
#include "upload/vertices.hpp"

#include <vector>

namespace velarium::upload {

// The texture coordinate sets that a material reads. More than two distinct ones do not fit a vertex.
[[nodiscard]] UvChoice uv_choice(const scene::Material& material);

// Bit i: slot i has a texture. Constant 0 of shaders that include upload/material.glsl.
[[nodiscard]] std::uint32_t slot_mask(const scene::Material& material);

// A material at an offset that every device can bind (256 is the largest alignment that Vulkan lets one ask for).
struct alignas(256) MaterialBlock {
  GpuMaterial material;
};

// The materials of the scene in order, then the default one, which kNone stands for.
[[nodiscard]] std::vector<MaterialBlock> gpu_materials(const scene::Scene& scene);

// Index into gpu_materials().
[[nodiscard]] std::uint32_t material_index(const scene::Scene& scene, std::int32_t material);

// The scene's material, or the default one.
[[nodiscard]] const scene::Material& material_or_default(const scene::Scene& scene, std::int32_t material);

}  // namespace velarium::upload
