// Diffuse reflection by rough surfaces. Every function gives pi f / albedo: 1 is Lambert.
// sigma: standard deviation of the facets' slope angle, radians (Oren-Nayar 1994).
// r: Fujii's mix, 0 (Lambert) .. 1; it is B / A of the 1994 model, not an angle.
#ifndef VEL_SHADING_DIFFUSE_GLSL
#define VEL_SHADING_DIFFUSE_GLSL

#include "shading/constants.glsl"
#include "shading/lang.glsl"

// A of Oren-Nayar 1994, q = sigma^2.
FN float oren_nayar_a(float q) {
  return 1.0f - 0.5f * q / (q + 0.33f);
}

// B of Oren-Nayar 1994, q = sigma^2.
FN float oren_nayar_b(float q) {
  return 0.45f * q / (q + 0.09f);
}

// The qualitative model of Oren-Nayar 1994: its short form, up to 0.1 below the full one.
FN float diffuse_oren_nayar(float n_dot_l, float n_dot_v, float l_dot_v, float sigma) {
  float q = sigma * sigma;
  float p = l_dot_v - n_dot_l * n_dot_v;
  return oren_nayar_a(q) + oren_nayar_b(q) * max(p, 0.0f) / max(max(n_dot_l, n_dot_v), 1e-4f);
}

// Gotanda 2012: follows the full single-bounce model of 1994 to about 0.03 without its trigonometry.
FN float diffuse_gotanda(float n_dot_l, float n_dot_v, float l_dot_v, float sigma) {
  float q = sigma * sigma;
  float p = l_dot_v - n_dot_l * n_dot_v;
  float t = p > 0.0f ? max(max(n_dot_l, n_dot_v), 1e-4f) : 1.0f;
  return max(oren_nayar_a(q) + oren_nayar_b(q) * p / t, 0.0f);
}

// Fujii's improved Oren-Nayar (2012): also holds, nearly, the light that bounces twice between facets.
FN float diffuse_fujii(float n_dot_l, float n_dot_v, float l_dot_v, float r) {
  require(r >= 0.0f && r <= 1.0f);
  float a = 1.0f / (1.0f + 0.2877934f * r);  // 1/2 - 2/(3 pi)
  float p = l_dot_v - n_dot_l * n_dot_v;
  float t = p > 0.0f ? max(max(n_dot_l, n_dot_v), 1e-4f) : 1.0f;
  return max(a * (1.0f + r * p / t), 0.0f);
}

// Fujii's r of a surface whose specular lobe has width alpha: B / A at sigma = atan(alpha), alpha being the slope
// of the facets. 0 at alpha 0, 0.58 at alpha 1.
FN float fujii_weight_from_alpha(float alpha) {
  float sigma = atan(alpha);
  float q = sigma * sigma;
  return clamp(oren_nayar_b(q) / oren_nayar_a(q), 0.0f, 1.0f);
}

// The bracket of one of the models: Lambert (glTF, Blinn-Phong) or Fujii (Ryse).
FN float diffuse(uint model, float n_dot_l, float n_dot_v, float l_dot_v, float alpha) {
  return model == kModelRyse ? diffuse_fujii(n_dot_l, n_dot_v, l_dot_v, fujii_weight_from_alpha(alpha)) : 1.0f;
}

#endif
