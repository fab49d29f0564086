// How many taps soft shadows take, of every map. GLSL only.
#ifndef VEL_UPLOAD_SHADOW_TAPS_GLSL
#define VEL_UPLOAD_SHADOW_TAPS_GLSL

layout(constant_id = 13) const uint kShadowTaps = 32u;  // of the widest penumbra; even

#endif
