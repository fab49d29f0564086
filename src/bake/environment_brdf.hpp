#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace velarium::bake {

// Directional albedo of the specular lobe [Lazarov 2013; Karis 2013]: (E0, E1), for f0 = 0 and f0 = 1 with f90 = 1, as
// environment_specular() of shading/brdf.glsl reads it. size x size texels, columns n.v, rows smoothness, texel i
// standing for i / (size - 1), so that both ends are exact: read it with linear filtering at environment_brdf_uv().
// model: shading::kModelGltf or kModelRyse, so that environments and lights agree. size >= 2. Within 1e-3 of the
// integral.
[[nodiscard]] std::vector<glm::vec2> environment_brdf(std::uint32_t size, std::uint32_t model);

// The same, computed once on this machine.
[[nodiscard]] std::vector<glm::vec2> cached_environment_brdf(std::uint32_t size, std::uint32_t model);

// One texel: the integral at n_dot_v in (0, 1], alpha > 0, over `rings` x `rings` half vectors.
[[nodiscard]] glm::vec2 integrate_environment_brdf(float n_dot_v, float alpha, std::uint32_t model,
                                                   std::uint32_t rings);

}  // namespace velarium::bake
