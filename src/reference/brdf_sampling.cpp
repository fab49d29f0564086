#include "reference/brdf_sampling.hpp"

#include "shading/host.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::reference {
namespace {

using shading::Surface, shading::vec2, shading::vec3;

// The least n.v that is sampled: what evaluate_brdf adds to it.
constexpr float kGrazing = 1e-5f;

// A lobe that reflects at all is chosen at least this often, since its share is an estimate.
constexpr float kLeastShare = 0.1f;

// Estimated directional albedo of the specular lobe for f0 = f90 = 1: fits to the integrals that src/bake tables, 0.25
// off at the worst, near the edge. Smith loses what rough surfaces bounce more than once; Ryse's k darkens on both
// sides, and so does Blinn-Phong's masking: (n.v)^2 of a mirror, 1/4 at alpha 1.
float white_specular_albedo(float n_dot_v, float alpha, std::uint32_t model) {
  if (model == shading::kModelBlinnPhong) return glm::mix(n_dot_v * n_dot_v, 0.25f, alpha);
  if (model == shading::kModelGltf) return 1.0f - 0.69f * alpha * std::sqrt(n_dot_v);
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
  // In both models light from most directions finds nearly all that a head-on view leaves to diffuse reflection.
  const float diffuse = shading::luminance(s.albedo) * shading::diffuse_share(s.f0, s.f0, model);
  if (specular <= 0.0f) return diffuse > 0.0f ? 0.0f : -1.0f;
  if (diffuse <= 0.0f) return 1.0f;
  return std::clamp(specular / (specular + diffuse), kLeastShare, 1.0f - kLeastShare);
}

// What does not depend on wi.
struct View {
  vec3 eye;       // wo, or its mirror image in the surface where it lies behind
  float n_dot_v;  // >= kGrazing
  float chance;   // of the specular lobe
};

View make_view(const Surface& s, float alpha, const vec3& wo, const vec3& specular_scale, std::uint32_t model) {
  const float n_dot_wo = glm::dot(s.normal_ws, wo);
  const float n_dot_v = std::max(std::abs(n_dot_wo), kGrazing);
  // Not for rounding's sake: at the edge wo + wi may be so short that the last digit of wo turns the half vector.
  const vec3 eye = n_dot_wo < -kGrazing ? wo - 2.0f * n_dot_wo * s.normal_ws : wo;
  return {eye, n_dot_v, specular_chance(s, alpha, n_dot_v, specular_scale, model)};
}

vec3 sample_specular(const vec3& normal, const View& view, float alpha, const vec2& u) {
  vec3 local = shading::to_tangent_space(view.eye, normal);
  local.z = view.n_dot_v;
  const vec3 h = shading::sample_ggx_visible_half_vector(local, u, alpha);
  return shading::from_tangent_space(2.0f * glm::dot(local, h) * h - local, normal);
}

// wi: above the surface.
float pdf_sr_mixture(const vec3& normal, const View& view, const vec3& wi, float alpha) {
  // As evaluate_brdf does it, digit for digit, so that the D of a narrow lobe cancels in the weight.
  const float sin2_theta_h = shading::sin2_of_half_vector(normal, shading::half_vector(view.eye, wi));
  return view.chance * shading::pdf_sr_ggx_visible(sin2_theta_h, view.n_dot_v, alpha) +
         (1.0f - view.chance) * shading::kInvPi * glm::dot(normal, wi);
}

}  // namespace

std::optional<BrdfSample> sample_brdf(const Surface& s, float alpha, const vec3& wo, const vec3& specular_scale,
                                      std::uint32_t model, float u_lobe, const vec2& u) {
  const View view = make_view(s, alpha, wo, specular_scale, model);
  if (view.chance < 0.0f) return std::nullopt;
  const vec3 chosen = u_lobe < view.chance
                          ? sample_specular(s.normal_ws, view, alpha, u)
                          : shading::from_tangent_space(shading::sample_cosine_hemisphere(u), s.normal_ws);
  const vec3 wi = glm::normalize(chosen);
  if (glm::dot(s.normal_ws, wi) <= 0.0f) return std::nullopt;
  const float pdf_sr = pdf_sr_mixture(s.normal_ws, view, wi, alpha);
  return BrdfSample{wi, shading::evaluate_brdf(s, alpha, wo, wi, specular_scale, model) / pdf_sr, pdf_sr};
}

float pdf_sr_brdf(const Surface& s, float alpha, const vec3& wo, const vec3& wi, const vec3& specular_scale,
                  std::uint32_t model) {
  if (glm::dot(s.normal_ws, wi) <= 0.0f) return 0.0f;
  const View view = make_view(s, alpha, wo, specular_scale, model);
  return view.chance < 0.0f ? 0.0f : pdf_sr_mixture(s.normal_ws, view, wi, alpha);
}

}  // namespace velarium::reference
