// The lamps that a tile's list names, added up. GLSL only.
#ifndef VEL_UPLOAD_LIGHT_LISTS_GLSL
#define VEL_UPLOAD_LIGHT_LISTS_GLSL

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

// Lights of the tile, kind by kind and in their order, so that every run adds in the same order.
//
// Loops test at their end: a software driver runs a body once more, masked, where the test stands before it.
vec3 punctual_lights(ShadingPoint p, FrameUniforms frame) {
  vec3 sum = vec3(0.0);
  uint word = 0u;
  if (frame.first_point > 0u) do {
      uint bits = tile_light_word(word, 0u, frame.first_point);
      if (bits != 0u) do {
          sum += light_directional(p, word * 32u + uint(findLSB(bits)));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < frame.first_point);

  word = frame.first_point / 32u;
  if (frame.first_spot > frame.first_point) do {
      uint bits = tile_light_word(word, frame.first_point, frame.first_spot);
      if (bits != 0u) do {
          sum += light_point(p, word * 32u + uint(findLSB(bits)));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < frame.first_spot);

  word = frame.first_spot / 32u;
  if (frame.light_count > frame.first_spot) do {
      uint bits = tile_light_word(word, frame.first_spot, frame.light_count);
      if (bits != 0u) do {
          sum += light_spot(p, word * 32u + uint(findLSB(bits)));
          bits &= bits - 1u;
        } while (bits != 0u);
    } while (++word * 32u < frame.light_count);
  return sum;
}

#endif
