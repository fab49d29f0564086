// Translucency maps: what BLEND surfaces leave of light, read beside maps of depth (shading/translucency.glsl). GLSL only.
#ifndef VEL_PASSES_TRANSLUCENCY_MAP_GLSL
#define VEL_PASSES_TRANSLUCENCY_MAP_GLSL

#include "shading/translucency.glsl"

// A translucency map knows nothing of BLEND surfaces behind opaque casters. So its filters leave out taps at which
// something opaque stands nearer to the light than the surfaces that the search found: rays that pass beside it meet the
// same surfaces as those next to them. Where all taps are such, what the search found stands for them; this weight beside
// theirs lets it.
const float kUnseenTranslucencyWeight = 1e-4;

// What passes the surface that is lit, where it is BLEND: passes that draw such set it.
vec3 receiver_transmittance = vec3(1.0);

vec3 map_transmittance(vec4 texel, float depth) {
  return map_transmittance(texel, depth, receiver_transmittance);
}

// A mean of four texels, each asked for itself whether it stands before the receiver; 1 where none is asked.
// place: u, v, layer.
//
// Drivers that run both sides of every branch leave loops early: there what is not asked costs one texel of four.
vec3 bilinear_transmittance(texture2DArray map, vec3 place, float depth, bool asked) {
  ivec2 size = textureSize(map, 0).xy;
  vec2 at = place.xy * vec2(size) - 0.5;
  vec2 share = at - floor(at);
  ivec2 low = clamp(ivec2(floor(at)), ivec2(0), size - 1), step = min(low + 1, size - 1) - low;
  int texels = asked ? 4 : 0;
  vec3 sum = vec3(asked ? 0.0 : 1.0);
  for (int i = 0; i < texels; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 weight = mix(1.0 - share, share, vec2(corner));
    sum += weight.x * weight.y * map_transmittance(texelFetch(map, ivec3(low + corner * step, place.z), 0), depth);
  }
  return sum;
}

#endif
