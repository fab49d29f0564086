// Unit vectors in few bits.
#ifndef VEL_SHADING_NORMAL_ENCODING_GLSL
#define VEL_SHADING_NORMAL_ENCODING_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"

// Best-fit normals [Kaplanyan 2010, CryENGINE 3]: 3 x UNORM8, each vector stored with the length whose rounded
// components lie closest to its direction. Components are integers from -127 to 127, stored as their codes less 128: 0 is
// one of them, so that axes are exact. (2c/255 - 1 of a plain UNORM8 has no 0, and would leave axes 0.32 degrees off.)
// Code 0 is no component's: a texel of zeros holds no normal. The best lengths come from a table
// (src/bake/normal_lengths.hpp).

// Where a table of size x size texels, size >= 2, holds the best length of n: the integer parts are column and row.
// Lengths of neighbours have nothing in common: nothing may filter.
//
// Of |n|, sorted and scaled to a largest of 1, s and d are the sum and the difference of the other two. All directions
// are the triangle d <= s <= 2 - d. Its halves on either side of s = 1 fill the square below and above the diagonal,
// as (s, d) and as (d, 2 - s): it resolves all directions alike, and wastes nothing but the diagonal, which parts them.
FN vec2 bfn_table_texel(vec3 n, float size) {
  vec3 m = abs(n);
  float largest = max_component(m);
  float smallest = min_component(m);
  float middle = max(min(m.x, m.y), min(max(m.x, m.y), m.z));
  require(largest > 0.0f);
  float s = (middle + smallest) / largest;
  float d = (middle - smallest) / largest;
  float last = size - 1.0f;
  vec2 texel = s <= 1.0f ? vec2(s * last + 1.0f, d * last) : vec2(d * last, (2.0f - s) * last + 1.0f);
  return min(texel, vec2(last));
}

// The other way: |n| sorted, largest (1) first. The diagonal, but for its end at (1, 1, 0), is read for no direction.
FN vec3 bfn_table_direction(vec2 texel, float size) {
  float last = size - 1.0f;
  bool below = texel.x >= texel.y;
  float s = below ? (texel.x - 1.0f) / last : 2.0f - (texel.y - 1.0f) / last;
  float d = below ? texel.y / last : texel.x / last;
  return vec3(1.0f, min(0.5f * (s + d), 1.0f), max(0.5f * (s - d), 0.0f));
}

// n: not null. table_value: k / 255, k of 1..127 the largest component to store, as read at bfn_table_texel(n). Gives the
// values to store, 0..1, for a target that rounds to the nearest code.
FN vec3 bfn_encode(vec3 n, float table_value) {
  float scale = 255.0f * table_value / max_component(abs(n));
  return (n * scale + vec3(128.0f)) / 255.0f;
}

// Rounds, as devices may leave a little beside the code / 255 that they read.
FN vec3 bfn_decode(vec3 stored) {
  return normalize(floor(255.0f * stored + vec3(0.5f)) - vec3(128.0f));
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
