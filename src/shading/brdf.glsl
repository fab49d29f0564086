#ifndef VEL_SHADING_BRDF_GLSL
#define VEL_SHADING_BRDF_GLSL

#include "shading/color.glsl"
#include "shading/constants.glsl"
#include "shading/diffuse.glsl"
#include "shading/lang.glsl"
#include "shading/microfacet.glsl"
#include "shading/surface.glsl"

// Share of the light that is left for diffuse reflection. Ryse: 1 - luminance of f0. Others: 1 - the largest channel of
// what the interface reflects (glTF 2.0, appendix B.3.4, and KHR_materials_specular, so that a tint does not colour the
// diffuse part by its complement).
FN float diffuse_share(vec3 f0, vec3 reflected, uint model) {
  float taken = model == kModelRyse ? luminance(f0) : max_component(reflected);
  return clamp(1.0f - taken, 0.0f, 1.0f);
}

// wo, wi: unit. Some short vector where they are opposite.
FN vec3 half_vector(vec3 wo, vec3 wi) {
  vec3 sum = wo + wi;
  return sum * inversesqrt(max(dot(sum, sum), 1e-12f));
}

// sin^2 of the angle between n and h, unit. Half vectors below the horizon, which light near the eye's opposite has where
// the normal turns away from the eye, count as on it: |n x h|^2 alone is as small at -n as at n, and puts a highlight there.
FN float sin2_of_half_vector(vec3 n, vec3 h) {
  vec3 n_cross_h = cross(n, h);
  return dot(n, h) > 0.0f ? min(dot(n_cross_h, n_cross_h), 1.0f) : 1.0f;
}

// evaluate_brdf() for an area light about wi. n_dot_l: what stands for n.wi, clipped by the horizon; 0 gives
// black. bent_half: unit, the half vector that the distribution of microfacets is asked for; v_dot_h: what Fresnel is.
FN vec3 evaluate_brdf_bent(IN(Surface) s, float alpha, vec3 wo, vec3 wi, float n_dot_l, vec3 bent_half, float v_dot_h,
                           vec3 specular_scale, uint model) {
  if (n_dot_l <= 0.0f) return vec3(0.0f);
  // Interpolated and mapped normals may turn away from the eye.
  float n_dot_v = abs(dot(s.normal_ws, wo)) + 1e-5f;

  vec3 fresnel = fresnel_schlick(s.f0, f90_from_f0(s.f0), clamp(v_dot_h, 0.0f, 1.0f));
  float d = distribution(model, sin2_of_half_vector(s.normal_ws, bent_half), alpha);
  vec3 specular = fresnel * specular_scale * (d * visibility(model, n_dot_l, n_dot_v, alpha));

  float bracket = diffuse(model, n_dot_l, n_dot_v, dot(wo, wi), alpha);
  vec3 diffused = s.albedo * (kInvPi * bracket * diffuse_share(s.f0, fresnel, model));
  return (diffused + specular) * n_dot_l;
}

// f_r(wo, wi) n.wi, per steradian: times radiance from wi, integrated over solid angle, it gives radiance towards wo.
// For a punctual light multiply by its irradiance on a plane facing it. 0 where wi is not above the surface.
// wo, wi: unit. alpha: the width to shade with, which may exceed that of s.smoothness (kMinAlphaPunctual).
// specular_scale: energy_compensation(), or 1.
FN vec3 evaluate_brdf(IN(Surface) s, float alpha, vec3 wo, vec3 wi, vec3 specular_scale, uint model) {
  vec3 h = half_vector(wo, wi);
  return evaluate_brdf_bent(s, alpha, wo, wi, dot(s.normal_ws, wi), h, dot(wo, h), specular_scale, model);
}

// Where a table of size x size texels, whose outermost texels stand for 0 and 1, is read for (n.v, smoothness).
FN vec2 environment_brdf_uv(float n_dot_v, float smoothness, float size) {
  return (vec2(n_dot_v, smoothness) * (size - 1.0f) + vec2(0.5f)) / size;
}

// Whose table that is: the legacy model has none of its own, so that environments shine as on glTF's.
FN uint environment_model(uint model) {
  return model == kModelRyse ? kModelRyse : kModelGltf;
}

// env_brdf: (E0, E1), directional albedo of the specular lobe for f0 = 0 and f0 = 1 (with f90 = 1), read from the table
// of src/bake at (n.v, smoothness) [Lazarov 2013; Karis 2013].

// What single-scattering microfacets lose to bounces between facets, given back [Turquin 2019, eq. 16]:
// 1 + f0 (1 / E1 - 1). For the glTF model alone: it would undo the darkening that Ryse's visibility term is meant to have,
// and knows nothing of Blinn-Phong's.
FN vec3 energy_compensation(vec3 f0, vec2 env_brdf) {
  require(env_brdf.y > 0.0f);
  return vec3(1.0f) + f0 * (1.0f / env_brdf.y - 1.0f);
}

// Specular albedo towards the eye under uniform light: the integral of D Vis (f0 + (f90 - f0) (1 - v.h)^5) n.l.
FN vec3 environment_specular(vec3 f0, float f90, vec2 env_brdf) {
  return f0 * (env_brdf.y - env_brdf.x) + vec3(f90 * env_brdf.x);
}

// What multiplies albedo times mean radiance. specular_response: environment_specular() with its compensation.
// In the glTF model a dielectric of albedo 1 then returns all of a uniform light: the white furnace closes.
FN float environment_diffuse_weight(vec3 f0, vec3 specular_response, uint model) {
  return diffuse_share(f0, specular_response, model);
}

#endif
