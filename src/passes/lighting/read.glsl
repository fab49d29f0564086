// The lights that a tile's list names, added up. GLSL only.
#ifndef VEL_PASSES_LIGHTING_READ_GLSL
#define VEL_PASSES_LIGHTING_READ_GLSL

#include "passes/illumination.glsl"
#include "passes/lighting/lighting_io.glsl"
#include "shading/contact_shadow.glsl"

// Which of lights 32 word .. 32 word + 31 reach this pixel's tile, a bit each. The includer defines it.
uint tile_light_word(uint word);

// The same for lights [first, end) alone. Precondition: the word holds some of them.
uint tile_light_word(uint word, uint first, uint end) {
  uint base = word * 32u;
  uint from = first > base ? 0xffffffffu << (first - base) : 0xffffffffu;
  uint to = end - base < 32u ? (1u << (end - base)) - 1u : 0xffffffffu;
  return tile_light_word(word) & from & to;
}

// What the lights of a pixel add, and the one of them that adds the most.
struct PunctualLight {
  vec3 sum;
  vec3 largest;   // what that one adds
  float key;      // its dominant_light_key()
};

PunctualLight with_light(PunctualLight found, uint index, vec3 radiance) {
  float key = dominant_light_key(luminance(radiance), index);
  vec3 largest = key > found.key ? radiance : found.largest;
  return PunctualLight(found.sum + radiance, largest, max(key, found.key));
}

// Lights of the tile, kind by kind and in their order, so that every run adds in the same order.
//
// Loops test at their end: a software driver runs a body once more, masked, where the test stands before it.
PunctualLight punctual_lights(ShadingPoint p) {
  PunctualLight found = PunctualLight(vec3(0.0), vec3(0.0), 0.0);
  uint word = 0u;
  if (light_ranges.first_point > 0u) do {
      uint bits = tile_light_word(word, 0u, light_ranges.first_point);
      if (bits != 0u) do {
          uint index = word * 32u + uint(findLSB(bits));
          found = with_light(found, index, light_directional(p, index));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < light_ranges.first_point);

  word = light_ranges.first_point / 32u;
  if (light_ranges.first_spot > light_ranges.first_point) do {
      uint bits = tile_light_word(word, light_ranges.first_point, light_ranges.first_spot);
      if (bits != 0u) do {
          uint index = word * 32u + uint(findLSB(bits));
          found = with_light(found, index, light_point(p, index));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < light_ranges.first_spot);

  word = light_ranges.first_spot / 32u;
  if (light_ranges.count > light_ranges.first_spot) do {
      uint bits = tile_light_word(word, light_ranges.first_spot, light_ranges.count);
      if (bits != 0u) do {
          uint index = word * 32u + uint(findLSB(bits));
          found = with_light(found, index, light_spot(p, index));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < light_ranges.count);
  return found;
}

#endif
