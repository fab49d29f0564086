#include "bake/environment_brdf.hpp"

#include "bake/table_cache.hpp"
#include "core/assert.hpp"
#include "core/jobs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "shading/host.hpp"

namespace velarium::bake {
namespace {

// To be raised with every change of what environment_brdf() returns.
constexpr int kVersion = 2;

// Leaves an error of 6e-4, held by tests/unit/bake/environment_brdf_test.cpp.
constexpr std::uint32_t kRings = 48;

// In place of n.v = 0, where the lobe's sampling is not defined.
constexpr float kGrazing = 1e-3f;

}  // namespace

glm::vec2 integrate_environment_brdf(float n_dot_v, float alpha, std::uint32_t model, std::uint32_t rings) {
  VEL_ASSERT(n_dot_v > 0.0f && n_dot_v <= 1.0f && rings > 0);
  const glm::vec3 wo{std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v};
  const float step = 1.0f / static_cast<float>(rings);
  glm::dvec2 sum{0.0};  // many nearly equal terms: fp32 would round them all the same way
  for (std::uint32_t i = 0; i < rings; ++i) {
    // Rings crowd at the lobe's rim, u = 1 - t^2: the long tail of GGX, half of it below the horizon, lies there, and
    // even rings would credit up to 1 % of it.
    const float t = 1.0f - (static_cast<float>(i) + 0.5f) * step;
    for (std::uint32_t j = 0; j < rings; ++j) {
      const float half_turn = 0.5f * (static_cast<float>(j) + 0.5f) * step;  // the other half mirrors it
      const glm::vec3 h = shading::sample_ggx_visible_half_vector(wo, {1.0f - t * t, half_turn}, alpha);
      const float v_dot_h = glm::dot(wo, h);
      const float n_dot_l = 2.0f * v_dot_h * h.z - n_dot_v;
      if (n_dot_l <= 0.0f) continue;
      const float weight = 2.0f * t * shading::visibility(model, n_dot_l, n_dot_v, alpha) * n_dot_l;
      sum += glm::dvec2(weight * shading::schlick_weight(v_dot_h), weight);
    }
  }
  // D Vis n.l / pdf: D cancels, and what is left of 1 / pdf is the same for all samples.
  return glm::vec2(sum) * (step * step * 2.0f * shading::ggx_smith_denominator(n_dot_v, alpha));
}

std::vector<glm::vec2> environment_brdf(std::uint32_t size, std::uint32_t model) {
  VEL_ASSERT(size > 1);
  std::vector<glm::vec2> table(std::size_t{size} * size);
  const float step = 1.0f / static_cast<float>(size - 1);
  parallel_for(size, [&](std::size_t y) {
    const float alpha = shading::alpha_from_smoothness(static_cast<float>(y) * step);
    for (std::size_t x = 0; x < size; ++x) {
      const float n_dot_v = std::max(static_cast<float>(x) * step, kGrazing);
      table[y * size + x] = integrate_environment_brdf(n_dot_v, alpha, model, kRings);
    }
  });
  return table;
}

std::vector<glm::vec2> cached_environment_brdf(std::uint32_t size, std::uint32_t model) {
  return cached_table<glm::vec2>(fmt::format("environment-brdf-{}-model{}-v{}.bin", size, model, kVersion),
                                 std::size_t{size} * size, [&] { return environment_brdf(size, model); });
}

}  // namespace velarium::bake
