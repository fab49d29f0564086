// Sequences, hashes, noise and the directions made of them. There is no state: noise comes from (pixel, frame, seed).
#ifndef VEL_SHADING_SAMPLING_GLSL
#define VEL_SHADING_SAMPLING_GLSL

#include "shading/constants.glsl"
#include "shading/lang.glsl"
#include "shading/microfacet.glsl"

// --- hashes -------------------------------------------------------------------------------------------------------

// PCG output permutation as a hash [Jarzynski & Olano 2020].
FN uint hash_u32(uint x) {
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// The top 24 bits, all that an fp32 holds, as a number in [0, 1).
FN float unit_float(uint bits) {
  return float(bits >> 8u) * (1.0f / 16777216.0f);
}

// A number in [0, 1) that looks random in x.
FN float hash_to_float(uint x) {
  return unit_float(hash_u32(x));
}

// --- sequences ----------------------------------------------------------------------------------------------------

// Van der Corput in base 2: the bits of i mirrored at the binary point, in [0, 1).
FN float radical_inverse(uint i) {
  uint bits = (i << 16u) | (i >> 16u);
  bits = ((bits & 0x00ff00ffu) << 8u) | ((bits & 0xff00ff00u) >> 8u);
  bits = ((bits & 0x0f0f0f0fu) << 4u) | ((bits & 0xf0f0f0f0u) >> 4u);
  bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xccccccccu) >> 2u);
  bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xaaaaaaaau) >> 1u);
  return unit_float(bits);
}

// Point i of the n-point Hammersley set, in [0, 1)^2.
FN vec2 hammersley(uint i, uint n) {
  require(i < n);
  return vec2((float(i) + 0.5f) / float(n), radical_inverse(i));
}

// Offset of the sampled point from the pixel's centre in [-1/2, 1/2]^2, repeating after `count` frames.
// The R2 sequence [Roberts 2018], taken symmetrically about its origin: for every count the offsets sum to zero, so
// that the average picture is not shifted, and a count of 1 samples the centre.
FN vec2 pixel_jitter(uint frame, uint count) {
  require(count > 0u);
  float i = float(frame % count) - 0.5f * float(count - 1u);
  return fract(vec2(0.5f) + i * vec2(0.754877666f, 0.569840291f)) - vec2(0.5f);
}

// --- screen noise -------------------------------------------------------------------------------------------------

// Interleaved gradient noise [Jimenez 2014] in [0, 1): near pixels differ much, so a small blur removes it.
FN float interleaved_gradient_noise(vec2 pixel) {
  return fract(52.9829189f * fract(dot(pixel, vec2(0.06711056f, 0.00583715f))));
}

// The same, moved by frame and seed.
FN float screen_noise(uvec2 pixel, uint frame, uint seed) {
  uint h = hash_u32(frame + hash_u32(seed));
  // 8-bit shifts keep the products above exact enough at 16k pixels.
  return interleaved_gradient_noise(vec2(pixel) + vec2(float(h & 255u), float((h >> 8u) & 255u)));
}

// --- directions ---------------------------------------------------------------------------------------------------

// From a frame whose z axis is n (unit) to the frame of n [Duff et al. 2017].
FN vec3 from_tangent_space(vec3 v, vec3 n) {
  float s = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  vec3 tangent = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
  vec3 bitangent = vec3(b, s + n.y * n.y * a, -n.y);
  return v.x * tangent + v.y * bitangent + v.z * n;
}

// GGX half vector about +z, u in [0, 1)^2; pdf_sr = D cos(theta_h) [Walter et al. 2007, eqs. 35, 36].
FN vec3 sample_ggx_half_vector(vec2 u, float alpha) {
  require(alpha > 0.0f);
  float a2 = alpha * alpha;
  float scale = 1.0f / (1.0f + (a2 - 1.0f) * u.x);
  float sin_theta = alpha * sqrt(u.x * scale);
  float phi = kTwoPi * u.y;
  return vec3(sin_theta * cos(phi), sin_theta * sin(phi), sqrt((1.0f - u.x) * scale));
}

// Half vector that wo sees: distributed as D masked and projected towards wo, for alpha > 0 [Heitz 2018], by the
// spherical cap of Dupuy & Benyoub 2023. wo: unit, about +z, wo.z > 0. u in [0, 1)^2.
FN vec3 sample_ggx_visible_half_vector(vec3 wo, vec2 u, float alpha) {
  require(alpha > 0.0f && wo.z > 0.0f);
  vec3 stretched = normalize(vec3(alpha * wo.x, alpha * wo.y, wo.z));
  float z = (1.0f - u.x) * (1.0f + stretched.z) - stretched.z;
  float sin_theta = sqrt(clamp(1.0f - z * z, 0.0f, 1.0f));
  float phi = kTwoPi * u.y;
  vec3 h = vec3(sin_theta * cos(phi), sin_theta * sin(phi), z) + stretched;
  return normalize(vec3(alpha * h.x, alpha * h.y, h.z));
}

// 1 / G1(wo) times 2 n.v: Smith's masking of one direction as sqrt(a2 + (1 - a2) (n.v)^2) + n.v [Walter 2007, eq. 34].
FN float ggx_smith_denominator(float n_dot_v, float alpha) {
  float a2 = alpha * alpha;
  return n_dot_v + sqrt(a2 + (1.0f - a2) * n_dot_v * n_dot_v);
}

// Density of the mirror direction about such a half vector, per steradian of wi: D G1(wo) / (4 n.v).
// sin2_theta_h: as d_ggx_from_sin2.
FN float pdf_sr_ggx_visible(float sin2_theta_h, float n_dot_v, float alpha) {
  return 0.5f * d_ggx_from_sin2(sin2_theta_h, alpha) / ggx_smith_denominator(n_dot_v, alpha);
}

#endif
