// What tiled lighting itself binds.
#ifndef VEL_PASSES_LIGHTING_OWN_IO_GLSL
#define VEL_PASSES_LIGHTING_OWN_IO_GLSL

#include "shading/lang.glsl"

const uint kNoPunctual = 0u;       // kPunctual: none shines
const uint kPunctualHere = 1u;     // they are asked here
const uint kPunctualVolumes = 2u;  // light_volumes has asked them

STORAGE(0, 6, rgba16f, image2D, hdr);                      // in: emissive; out: the lit picture
SAMPLED(0, 7, texture2D, background_map);                  // equirectangular
TABLE(0, 8, BoundsBuffer, vec4 light_bounds[]);            // view space spheres
OUT_TABLE(0, 9, OwnListBuffer, uint own_forward_lists[]);  // ForwardListBuffer, while it is made
SAMPLED(0, 10, texture2D, volume_light);                   // what light_volumes has found
CONSTANT(bool, kTiled, 30, true);                          // else every light at every pixel
CONSTANT(bool, kForwardLists, 31, false);                  // write the lists that transparent surfaces need
CONSTANT(uint, kPunctual, 32, 1u);
GROUP_SIZE_X(kTileThreads, 33);                            // that share a tile, a divisor of its 256 pixels

#endif
