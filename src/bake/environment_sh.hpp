#pragma once

#include "image/image.hpp"

#include <glm/vec4.hpp>

#include <array>

namespace velarium::bake {

// Integrals of radiance times each function of shading/environment.glsl's sh_basis over all directions; w is 0.
// Exact where each pixel of the equirectangular picture is taken as a patch of constant radiance. Sums in double, in
// an order that depends on the size of the picture alone.
[[nodiscard]] std::array<glm::vec4, 9> project_sh(const image::FloatImage& equirect);

}  // namespace velarium::bake
