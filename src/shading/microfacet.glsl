// Specular reflection by microfacets: f = D F Vis. Angles are cosines; "per steradian" is of half vectors.
#ifndef VEL_SHADING_MICROFACET_GLSL
#define VEL_SHADING_MICROFACET_GLSL

#include "shading/color.glsl"
#include "shading/constants.glsl"
#include "shading/lang.glsl"

// GGX normal distribution [Walter et al. 2007, eq. 33], per steradian, from sin^2 of the angle between n and h.
// Normalised so that the hemisphere integral of D cos(theta_h) is 1. Give |n x h|^2: for narrow lobes
// 1 - (n.h)^2 has no digits left in fp32 (at alpha 0.0007 one step of n.h moves D by a fifth).
FN float d_ggx_from_sin2(float sin2_theta_h, float alpha) {
  require(alpha > 0.0f && sin2_theta_h >= 0.0f);
  float a2 = alpha * alpha;
  float t = sin2_theta_h + a2 * (1.0f - sin2_theta_h);
  return a2 / (kPi * t * t);
}

// The same from n.h in [0, 1], for callers without the vectors.
FN float d_ggx(float n_dot_h, float alpha) {
  return d_ggx_from_sin2(max((1.0f - n_dot_h) * (1.0f + n_dot_h), 0.0f), alpha);
}

// G / (4 n.l n.v) with height-correlated Smith masking and shadowing [Heitz 2014, eq. 99].
// n_dot_l >= 0, n_dot_v > 0, alpha > 0.
FN float visibility_smith(float n_dot_l, float n_dot_v, float alpha) {
  require(n_dot_l >= 0.0f && n_dot_v > 0.0f && alpha > 0.0f);
  float a2 = alpha * alpha;
  float masking = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0f - a2) + a2);
  float shadowing = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0f - a2) + a2);
  return 0.5f / (masking + shadowing);
}

// Ryse's k of the Schlick-Smith form [Schulz 2014]: never 0, so that smooth surfaces darken towards grazing angles too.
FN float ryse_k(float alpha) {
  float base = 0.8f + 0.5f * alpha;
  return 0.5f * base * base;
}

// G / (4 n.l n.v) as in Ryse: 1 / (4 (n.l (1 - k) + k) (n.v (1 - k) + k)).
FN float visibility_ryse(float n_dot_l, float n_dot_v, float alpha) {
  require(n_dot_l >= 0.0f && n_dot_v >= 0.0f);
  float k = ryse_k(alpha);
  return 0.25f / ((n_dot_l * (1.0f - k) + k) * (n_dot_v * (1.0f - k) + k));
}

// log2(1 - x), x in [0, 1]: where x is small 1 - x has few of its digits left in fp32, so the logarithm's series takes
// over while its next term, x^6 / 6, is below a step of the result.
FN float log2_one_minus(float x) {
  require(x >= 0.0f && x <= 1.0f);
  float series = -1.44269504f * x * (1.0f + x * (1.0f / 2.0f + x * (1.0f / 3.0f + x * (1.0f / 4.0f + x * (1.0f / 5.0f)))));
  return x < 0.0625f ? series : log2(max(1.0f - x, 1e-30f));
}

// The exponent n of the Blinn-Phong lobe that peaks as high as the GGX lobe of this width: (n + 2) / (2 pi) = 1 / (pi
// alpha^2). alpha in (0, 1]. CryENGINE's own n = 2^(10 gloss + 1) belongs to gloss maps made for it; its 2048 is the
// smoothness 0.63, and what is smoother would all look alike.
FN float blinn_phong_exponent(float alpha) {
  require(alpha > 0.0f && alpha <= 1.0f);
  return 2.0f / (alpha * alpha) - 2.0f;
}

// Normalised Blinn-Phong distribution (n + 2) / (2 pi) (n.h)^n [Hoffman 2010; Blinn 1977], per steradian: the hemisphere
// integral of D cos(theta_h) is 1. From |n x h|^2, as d_ggx_from_sin2.
FN float d_blinn_phong_from_sin2(float sin2_theta_h, float alpha) {
  return kInvPi / (alpha * alpha) * exp2(0.5f * blinn_phong_exponent(alpha) * log2_one_minus(sin2_theta_h));
}

// D of one of the models.
FN float distribution(uint model, float sin2_theta_h, float alpha) {
  return model == kModelBlinnPhong ? d_blinn_phong_from_sin2(sin2_theta_h, alpha)
                                   : d_ggx_from_sin2(sin2_theta_h, alpha);
}

// Vis of one of the models. Blinn-Phong's 1/4 is what the masking n.l n.v leaves, which Hoffman 2010 calls implicit.
FN float visibility(uint model, float n_dot_l, float n_dot_v, float alpha) {
  if (model == kModelBlinnPhong) return 0.25f;
  return model == kModelRyse ? visibility_ryse(n_dot_l, n_dot_v, alpha) : visibility_smith(n_dot_l, n_dot_v, alpha);
}

// (1 - cos)^5, the shape of Schlick's curve; cosine in [0, 1].
FN float schlick_weight(float cosine) {
  float m = clamp(1.0f - cosine, 0.0f, 1.0f);
  float m2 = m * m;
  return m2 * m2 * m;
}

// Fresnel reflectance [Schlick 1994]: f0 at normal incidence, f90 at grazing.
FN vec3 fresnel_schlick(vec3 f0, float f90, float v_dot_h) {
  return f0 + (vec3(f90) - f0) * schlick_weight(v_dot_h);
}

// Grazing reflectance that a material with this f0 has. No real surface reflects less than 2 %, so a smaller f0 says
// that something blocks the light (specular 0 in KHR_materials_specular), and grazing light fades with it. The largest
// channel decides: a tint takes colour away, and must not take the rim.
FN float f90_from_f0(vec3 f0) {
  return clamp(50.0f * max_component(f0), 0.0f, 1.0f);
}

#endif
