#ifndef VEL_BAKE_ROUND_TO_HALF_GLSL
#define VEL_BAKE_ROUND_TO_HALF_GLSL

#include "shading/constants.glsl"

// The nearest numbers that a half holds, for 0 <= x. A store to rgba16f may round in either direction [Vulkan
// specification, "Floating-Point Format Conversions"], and drivers that cut digits off would darken every level.
vec3 round_to_half(vec3 x) {
  uvec3 bits = floatBitsToUint(min(x, vec3(kLargestHalf)));
  bits += uvec3(0xfffu) + ((bits >> 13u) & uvec3(1u));
  return uintBitsToFloat(bits & ~uvec3(0x1fffu));
}

#endif
