// Unit vectors in few bits.
#ifndef VEL_SHADING_NORMAL_ENCODING_GLSL
#define VEL_SHADING_NORMAL_ENCODING_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"

// Best-fit normals [Kaplanyan 2010, CryENGINE 3]: 3 x UNORM8, each vector stored with the length whose rounded code
// lies closest to its direction. UNORM8 decodes c to 2c/255 - 1: the codes are odd integers / 255, and 0 is none of
// them, so an axis keeps an error of 0.32 degrees. The best lengths come from a table (src/bake/normal_lengths.hpp).

// Where the table holds the best length of n: (middle / largest, smallest / middle) of the sorted |n|, in [0, 1].
// Read the nearest texel, clamped to the edge: a length between two good ones means nothing.
FN vec2 bfn_table_uv(vec3 n) {
  vec3 m = abs(n);
  float largest = max_component(m);
  float smallest = min_component(m);
  float middle = max(min(m.x, m.y), min(max(m.x, m.y), m.z));
  require(largest > 0.0f);
  return vec2(middle / largest, smallest / max(middle, 1e-6f * largest));
}

// n: not null. table_value: k / 255 with k odd, as read at bfn_table_uv(n). Gives the values to store, 0..1,
// for a target that rounds to the nearest code.
FN vec3 bfn_encode(vec3 n, float table_value) {
  float scale = 0.5f * table_value / max_component(abs(n));
  return n * scale + vec3(0.5f);
}

FN vec3 bfn_decode(vec3 stored) {
  return normalize(2.0f * stored - vec3(1.0f));
}

// Octahedral map [Cigolle et al. 2014]: unit vector <-> square [-1, 1]^2, the folded octahedron seen along z.
FN vec2 oct_fold(vec2 p) {
  return vec2((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f), (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f));
}

FN vec2 oct_encode(vec3 n) {
  vec2 p = vec2(n.x, n.y) / (abs(n.x) + abs(n.y) + abs(n.z));
  return n.z < 0.0f ? oct_fold(p) : p;
}

FN vec3 oct_decode(vec2 p) {
  float z = 1.0f - abs(p.x) - abs(p.y);
  vec2 xy = z < 0.0f ? oct_fold(p) : p;
  return normalize(vec3(xy.x, xy.y, z));
}

#endif
