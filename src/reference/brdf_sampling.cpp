#include "reference/brdf_sampling.hpp"

#include "shading/host.hpp"

#include <algorithm>

namespace velarium::reference {
namespace {

using shading::Surface, shading::vec2, shading::vec3;

// The least n.v that is sampled: what evaluate_brdf adds to it.
constexpr float kGrazing = 1e-5f;

// A lobe that reflects at all is chosen at least this often, since its share is an estimate.
constexpr float kLeastShare = 0.1f;

// Estimated directional albedo of the specular lobe for f0 = f90 = 1: fits, to 0.15 at the worst, to the integrals that
// src/bake tables. Smith loses what rough surfaces bounce more than once; Ryse's k darkens on both sides.
float white_specular_albedo(float n_dot_v, float alpha, std::uint32_t model) {
  if (model != shading::kModelRyse) return 1.0f - 0.69f * alpha * std::sqrt(n_dot_v);
  const float k = shading::ryse_k(alpha);
  const float masking = n_dot_v / (n_dot_v * (1.0f - k) + k);
  return glm::mix(masking * masking, 0.28f, alpha);
}

// The chance of the specular lobe: its share of the light that is reflected towards n_dot_v. Negative where nothing is.
float specular_chance(const Surface& s, float alpha, float n_dot_v, const vec3& specular_scale, std::uint32_t model) {
  // Roughness spreads half vectors, and takes Fresnel's rise towards grazing angles away: fitted as above.
  const float rise = shading::schlick_weight(n_dot_v) / (1.0f + 20.0f * alpha);
  const vec3 fresnel = glm::mix(s.f0, vec3(shading::f90_from_f0(s.f0)), rise);
  const float specular = shading::luminance(fresnel * specular_scale) * white_specular_albedo(n_dot_v, alpha, model);
  const float diffuse = shading::luminance(s.albedo) * shading::diffuse_share(s.f0, fresnel, model);
  if (specular <= 0.0f) return diffuse > 0.0f ? 0.0f : -1.0f;
  if (diffuse <= 0.0f) return 1.0f;
  return std::clamp(specular / (specular + diffuse), kLeastShare, 1.0f - kLeastShare);
}

// wo, or its mirror image in the surface where it lies behind.
vec3 in_front(const vec3& wo, const vec3& normal) {
  return wo - 2.0f * std::min(glm::dot(wo, normal), 0.0f) * normal;
}

vec3 sample_specular(const vec3& normal, const vec3& eye, float alpha, const vec2& u) {
  vec3 local = shading::to_tangent_space(eye, normal);
  local.z = std::max(local.z, kGrazing);
  const vec3 h = shading::sample_ggx_visible_half_vector(local, u, alpha);
  return shading::from_tangent_space(2.0f * glm::dot(local, h) * h - local, normal);
}

// eye: in front of the surface.
float pdf_sr_mixture(const vec3& normal, const vec3& eye, const vec3& wi, float alpha, float chance) {
  // As evaluate_brdf does it, digit for digit, so that the D of a narrow lobe cancels in the weight.
  const vec3 sum = eye + wi;
  const vec3 h = sum * glm::inversesqrt(std::max(glm::dot(sum, sum), 1e-12f));
  const vec3 n_cross_h = glm::cross(normal, h);
  const float sin2_theta_h = std::min(glm::dot(n_cross_h, n_cross_h), 1.0f);
  const float n_dot_v = std::max(glm::dot(normal, eye), kGrazing);
  return chance * shading::pdf_sr_ggx_visible(sin2_theta_h, n_dot_v, alpha) +
         (1.0f - chance) * shading::kInvPi * glm::dot(normal, wi);
}

}  // namespace

std::optional<BrdfSample> sample_brdf(const Surface& s, float alpha, const vec3& wo, const vec3& specular_scale,
                                      std::uint32_t model, float u_lobe, const vec2& u) {
  const vec3 eye = in_front(wo, s.normal_ws);
  const float chance = specular_chance(s, alpha, glm::dot(s.normal_ws, eye), specular_scale, model);
  if (chance < 0.0f) return std::nullopt;
  const vec3 chosen = u_lobe < chance ? sample_specular(s.normal_ws, eye, alpha, u)
                                      : shading::from_tangent_space(shading::sample_cosine_hemisphere(u), s.normal_ws);
  const vec3 wi = glm::normalize(chosen);
  if (glm::dot(s.normal_ws, wi) <= 0.0f) return std::nullopt;
  const float pdf_sr = pdf_sr_mixture(s.normal_ws, eye, wi, alpha, chance);
  return BrdfSample{wi, shading::evaluate_brdf(s, alpha, wo, wi, specular_scale, model) / pdf_sr, pdf_sr};
}

float pdf_sr_brdf(const Surface& s, float alpha, const vec3& wo, const vec3& wi, const vec3& specular_scale,
                  std::uint32_t model) {
  if (glm::dot(s.normal_ws, wi) <= 0.0f) return 0.0f;
  const vec3 eye = in_front(wo, s.normal_ws);
  const float chance = specular_chance(s, alpha, glm::dot(s.normal_ws, eye), specular_scale, model);
  return chance < 0.0f ? 0.0f : pdf_sr_mixture(s.normal_ws, eye, wi, alpha, chance);
}

}  // namespace velarium::reference
