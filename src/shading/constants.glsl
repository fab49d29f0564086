#ifndef VEL_SHADING_CONSTANTS_GLSL
#define VEL_SHADING_CONSTANTS_GLSL

#include "shading/lang.glsl"

const float kPi = 3.14159265358979f;
const float kTwoPi = 6.28318530717959f;
const float kHalfPi = 1.57079632679490f;
const float kInvPi = 0.318309886183791f;

const float kLargestHalf = 65504.0f;  // the largest finite number of 16 bits [IEEE 754-2008, binary16]

// Which reflectance model shades a surface; the order of velarium::ShadingModel.
const uint kModelGltf = 0u;  // glTF 2.0, appendix B: height-correlated Smith, Lambert
const uint kModelRyse = 1u;  // Ryse (Schulz, GDC 2014): Schlick-Smith with its own k, Oren-Nayar
const uint kModelBlinnPhong = 2u;  // CryENGINE 3 (SIGGRAPH 2011): normalised Blinn-Phong, Lambert

#endif
