#pragma once

// Directions chosen in proportion to what shading/brdf.glsl reflects.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace velarium::shading {
struct Surface;
}

namespace velarium::reference {

struct BrdfSample {
  glm::vec3 wi;      // unit, above the surface
  glm::vec3 weight;  // evaluate_brdf() / pdf_sr: what the path's throughput is multiplied by
  float pdf_sr;      // of wi, both lobes together; > 0
};

// The arguments are those of shading::evaluate_brdf: unit directions, alpha >= kMinAlpha, specular_scale from
// energy_compensation() or 1, any model. One lobe is chosen by its share of the albedo: visible GGX normals [Heitz
// 2018; Dupuy & Benyoub 2023], or the cosine. The density is that of the mixture.
//
// wo may lie behind the shading normal, where interpolation or a normal map turned it. evaluate_brdf then shades with
// |n.wo|, and normals are sampled as wo's mirror image in the surface sees them: about that half vector D is nowhere
// smaller than about the true one, so that the weights stay as bounded as in front: specular ones by 10, and Lambert's
// too. Fujii's rise towards light that returns to a grazing eye, as 1 / max(n.wi, n.wo). Blinn-Phong's by 4/e more: of
// the GGX lobe of the same peak it exceeds no more, as (1 - t)^m (1 + t m)^2 < (1 + t m)^2 / e^(t m).
//
// u_lobe, u: uniform in [0, 1). Nothing is returned where the chosen direction is under the surface, or the surface
// reflects nothing: the path ends.
[[nodiscard]] std::optional<BrdfSample> sample_brdf(const shading::Surface& s, float alpha, const glm::vec3& wo,
                                                    const glm::vec3& specular_scale, std::uint32_t model, float u_lobe,
                                                    const glm::vec2& u);

// Density with which sample_brdf() returns wi, per steradian; 0 under the surface. Integrates to the share of calls
// that return something.
[[nodiscard]] float pdf_sr_brdf(const shading::Surface& s, float alpha, const glm::vec3& wo, const glm::vec3& wi,
                                const glm::vec3& specular_scale, std::uint32_t model);

}  // namespace velarium::reference
