#pragma once

#include "gpu/image.hpp"
#include "gpu/gpu_context.hpp"

namespace velarium::bake {

// What bake_specular_cube() makes, and what its cached bytes fill.
[[nodiscard]] gpu::ImageDesc specular_cube_desc();

// Environment::specular from Environment::background. May be copied from.
[[nodiscard]] gpu::Image bake_specular_cube(gpu::GpuContext& tools, const gpu::Image& background);

}  // namespace velarium::bake
