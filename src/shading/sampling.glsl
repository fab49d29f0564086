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

FN uint reverse_bits(uint x) {
  uint bits = (x << 16u) | (x >> 16u);
  bits = ((bits & 0x00ff00ffu) << 8u) | ((bits & 0xff00ff00u) >> 8u);
  bits = ((bits & 0x0f0f0f0fu) << 4u) | ((bits & 0xf0f0f0f0u) >> 4u);
  bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xccccccccu) >> 2u);
  return ((bits & 0x55555555u) << 1u) | ((bits & 0xaaaaaaaau) >> 1u);
}

// Van der Corput in base 2: the bits of i mirrored at the binary point, in [0, 1).
FN float radical_inverse(uint i) {
  return unit_float(reverse_bits(i));
}

// Point i of the n-point Hammersley set, in [0, 1)^2.
FN vec2 hammersley(uint i, uint n) {
  require(i < n);
  return vec2((float(i) + 0.5f) / float(n), radical_inverse(i));
}

// The second dimension of Sobol's sequence, of the polynomial x + 1, before its bits are mirrored: its generator matrix
// is Pascal's triangle modulo 2, which is Kronecker's fifth power of (1 1; 0 1), hence one step for each factor.
FN uint sobol_second_dimension(uint i) {
  i ^= (i >> 1u) & 0x55555555u;
  i ^= (i >> 2u) & 0x33333333u;
  i ^= (i >> 4u) & 0x0f0f0f0fu;
  i ^= (i >> 8u) & 0x00ff00ffu;
  return i ^ ((i >> 16u) & 0x0000ffffu);
}

// Owen's nested uniform scrambling of a number whose bits are mirrored: each bit is flipped or kept depending on all bits
// below it, and nothing else [Laine & Karras 2011; Burley 2020], with the constants that Vegdahl found by search (2021).
FN uint nested_scramble(uint mirrored, uint seed) {
  uint x = mirrored ^ (mirrored * 0x3d20adeau);
  x += seed;
  x *= (seed >> 16u) | 1u;
  x ^= x * 0x05526c56u;
  return x ^ (x * 0x53a22864u);
}

// The place that `index` has after a shuffle which keeps aligned blocks of 2^k together, for every k.
FN uint nested_shuffle(uint index, uint seed) {
  return reverse_bits(nested_scramble(reverse_bits(index), seed));
}

// Point `index` of Sobol's sequence in one and in two dimensions, shuffled and scrambled by the seed, in [0, 1).
// Whatever the seed, any aligned block of 2^k points has one in each elementary interval of size 2^-k; points of
// different seeds are independent [Burley 2020].
FN float scrambled_sobol_1d(uint index, uint seed) {
  uint shuffled = nested_shuffle(index, seed);
  return unit_float(reverse_bits(nested_scramble(shuffled, hash_u32(seed))));
}

FN vec2 scrambled_sobol_2d(uint index, uint seed) {
  uint shuffled = nested_shuffle(index, seed);
  uint seed_x = hash_u32(seed);
  uint x = nested_scramble(shuffled, seed_x);
  uint y = nested_scramble(sobol_second_dimension(shuffled), hash_u32(seed_x));
  return vec2(unit_float(reverse_bits(x)), unit_float(reverse_bits(y)));
}

// Offset of the sampled point from the pixel's centre in [-1/2, 1/2]^2, repeating after `count` frames.
// The R2 sequence [Roberts 2018], taken symmetrically about its origin: for every count the offsets sum to zero, so
// that the average picture is not shifted, and a count of 1 samples the centre.
FN vec2 pixel_jitter(uint frame, uint count) {
  require(count > 0u);
  float i = float(frame % count) - 0.5f * float(count - 1u);
  return fract(vec2(0.5f) + i * vec2(0.754877666f, 0.569840291f)) - vec2(0.5f);
}

// How far values move before they are rounded to codes, in codes, [-1/2, 1/2], repeating after `count` frames: the average
// picture then knows values between two codes. As pixel_jitter it sums to zero, and a count of 1 moves nothing; the
// silver ratio's fraction keeps it apart from what else follows the frame.
FN float rounding_shift(uint frame, uint count) {
  require(count > 0u);
  float i = float(frame % count) - 0.5f * float(count - 1u);
  return fract(0.5f + i * 0.414213562f) - 0.5f;
}

// --- screen noise -------------------------------------------------------------------------------------------------

// Interleaved gradient noise [Jimenez 2014] in [0, 1): near pixels differ much, so a small blur removes it.
FN float interleaved_gradient_noise(vec2 pixel) {
  return fract(52.9829189f * fract(dot(pixel, vec2(0.06711056f, 0.00583715f))));
}

// The golden ratio's fraction in units of 2^-32: multiples of it fill [0, 1) evenly, however many there are.
const uint kGoldenRatioBits = 2654435769u;

// The same, moved by the seed; from frame to frame each pixel goes on by the golden ratio, so that what is averaged over
// frames has had noise from all of [0, 1).
FN float screen_noise(uvec2 pixel, uint frame, uint seed) {
  uint h = hash_u32(seed);
  // 8-bit shifts keep the products above exact enough at 16k pixels.
  vec2 place = vec2(pixel) + vec2(float(h & 255u), float((h >> 8u) & 255u));
  return fract(interleaved_gradient_noise(place) + unit_float(frame * kGoldenRatioBits));
}

// --- directions ---------------------------------------------------------------------------------------------------

// Two unit vectors that make a right-handed frame with n (unit) as its z axis [Duff et al. 2017].
FN void tangent_frame(vec3 n, OUT(vec3) tangent, OUT(vec3) bitangent) {
  float s = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  tangent = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
  bitangent = vec3(b, s + n.y * n.y * a, -n.y);
}

// From that frame to the frame of n.
FN vec3 from_tangent_space(vec3 v, vec3 n) {
  vec3 tangent, bitangent;
  tangent_frame(n, tangent, bitangent);
  return v.x * tangent + v.y * bitangent + v.z * n;
}

// From the frame of n to that frame.
FN vec3 to_tangent_space(vec3 v, vec3 n) {
  vec3 tangent, bitangent;
  tangent_frame(n, tangent, bitangent);
  return vec3(dot(v, tangent), dot(v, bitangent), dot(v, n));
}

// Uniform over the unit disc, u in [0, 1)^2. Squares about the middle become circles, so that well-spread points stay so
// [Shirley & Chiu 1997].
FN vec2 sample_disc(vec2 u) {
  vec2 p = 2.0f * u - vec2(1.0f);
  if (p.x == 0.0f && p.y == 0.0f) return vec2(0.0f);
  bool wide = abs(p.x) > abs(p.y);
  float radius = wide ? p.x : p.y;
  float angle = wide ? 0.25f * kPi * (p.y / p.x) : kHalfPi - 0.25f * kPi * (p.x / p.y);
  return radius * vec2(cos(angle), sin(angle));
}

// Direction about +z, z >= 0, u in [0, 1)^2; pdf_sr = cos(theta) / pi: the disc lifted to the hemisphere [Malley].
FN vec3 sample_cosine_hemisphere(vec2 u) {
  vec2 p = sample_disc(u);
  // Of the square that became the disc: at the rim the disc's own radius has lost the digits that a root brings up.
  vec2 square = abs(2.0f * u - vec2(1.0f));
  float radius = max(square.x, square.y);
  return vec3(p, sqrt((1.0f - radius) * (1.0f + radius)));
}

// 1 - cos of the half angle of the cone that a sphere fills, from sin^2 = (radius / distance)^2 in [0, 1]; the
// difference of cosines has no digits left for small spheres far away.
FN float cone_height(float sin2_half_angle) {
  require(sin2_half_angle >= 0.0f && sin2_half_angle <= 1.0f);
  return sin2_half_angle / (1.0f + sqrt(1.0f - sin2_half_angle));
}

// Uniform over the cone about +z with 1 - cos(half angle) = height in (0, 2], u in [0, 1)^2;
// pdf_sr = 1 / (2 pi height).
FN vec3 sample_cone(vec2 u, float height) {
  float below = u.x * height;  // 1 - z
  float sin_theta = sqrt(max(below * (2.0f - below), 0.0f));
  float phi = kTwoPi * u.y;
  return vec3(sin_theta * cos(phi), sin_theta * sin(phi), 1.0f - below);
}

FN float pdf_sr_cone(float height) {
  require(height > 0.0f);
  return 1.0f / (kTwoPi * height);
}

// Barycentric coordinates uniform over a triangle, u in [0, 1)^2; pdf_m2 = 1 / area. The square is folded at a diagonal,
// which moves points less than a square root would [Heitz 2019, "A Low-Distortion Map Between Triangle and Square"].
FN vec3 sample_triangle(vec2 u) {
  vec2 b = u.y > u.x ? vec2(0.5f * u.x, u.y - 0.5f * u.x) : vec2(u.x - 0.5f * u.y, 0.5f * u.y);
  return vec3(b, 1.0f - b.x - b.y);
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
