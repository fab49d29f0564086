// The lamps that a tile's list names, added up. GLSL only.
#ifndef VEL_UPLOAD_LIGHT_LISTS_GLSL
#define VEL_UPLOAD_LIGHT_LISTS_GLSL

#include "shading/contact_shadow.glsl"
#include "upload/frame_lighting.glsl"

// Which of lights 32 word .. 32 word + 31 reach this pixel's tile, a bit each. The includer defines it.
uint tile_light_word(uint word);

// The same for lights [first, end) alone. Precondition: the word holds some of them.
uint tile_light_word(uint word, uint first, uint end) {
  uint base = word * 32u;
  uint from = first > base ? 0xffffffffu << (first - base) : 0xffffffffu;
  uint to = end - base < 32u ? (1u << (end - base)) - 1u : 0xffffffffu;
  return tile_light_word(word) & from & to;
}

// What the lamps of a pixel add, and the one of them that adds the most.
struct LampLight {
  vec3 sum;
  vec3 largest;   // what that one adds
  float key;      // its strength_key()
};

LampLight with_lamp(LampLight lamps, uint index, vec3 radiance) {
  float key = strength_key(luminance(radiance), index);
  vec3 largest = key > lamps.key ? radiance : lamps.largest;
  return LampLight(lamps.sum + radiance, largest, max(key, lamps.key));
}

// Lights of the tile, kind by kind and in their order, so that every run adds in the same order.
//
// Loops test at their end: a software driver runs a body once more, masked, where the test stands before it.
LampLight punctual_lights(ShadingPoint p, FrameUniforms frame) {
  LampLight lamps = LampLight(vec3(0.0), vec3(0.0), 0.0);
  uint word = 0u;
  if (frame.first_point > 0u) do {
      uint bits = tile_light_word(word, 0u, frame.first_point);
      if (bits != 0u) do {
          uint index = word * 32u + uint(findLSB(bits));
          lamps = with_lamp(lamps, index, light_directional(p, index));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < frame.first_point);

  word = frame.first_point / 32u;
  if (frame.first_spot > frame.first_point) do {
      uint bits = tile_light_word(word, frame.first_point, frame.first_spot);
      if (bits != 0u) do {
          uint index = word * 32u + uint(findLSB(bits));
          lamps = with_lamp(lamps, index, light_point(p, index));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < frame.first_spot);

  word = frame.first_spot / 32u;
  if (frame.light_count > frame.first_spot) do {
      uint bits = tile_light_word(word, frame.first_spot, frame.light_count);
      if (bits != 0u) do {
          uint index = word * 32u + uint(findLSB(bits));
          lamps = with_lamp(lamps, index, light_spot(p, index));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < frame.light_count);
  return lamps;
}

#endif
