// What BLEND surfaces leave of light, read from maps that lie beside those of depth: shading/translucency.glsl. GLSL only.
#ifndef VEL_UPLOAD_VEILS_GLSL
#define VEL_UPLOAD_VEILS_GLSL

#include "shading/translucency.glsl"

layout(constant_id = 12) const uint kTranslucentShadows = 0u;  // of kSunVeils and kLocalVeils those that there are

const uint kSunVeils = 1u;
const uint kLocalVeils = 2u;

// A map of veils knows nothing of those behind opaque casters. So the filters leave out taps at which something opaque
// stands nearer to the light than the veils that the search found: rays that pass beside it meet the same veils as those
// next to them. Where all taps are such, what the search found stands for them; this weight beside theirs lets it.
const float kUnseenVeilWeight = 1e-4;

// What passes the surface that is lit, where it is BLEND: passes that draw such set it.
vec3 own_veil = vec3(1.0);

vec3 past_veil(vec4 veil, float depth) {
  return past_veil(veil, depth, own_veil);
}

// A mean of four texels, each asked for itself whether it stands before the receiver; 1 where none is asked. place: u, v, layer.
//
// Drivers that run both sides of every branch leave loops early: there what is not asked costs one texel of four.
vec3 bilinear_veil(sampler2DArray veils, vec3 place, float depth, bool asked) {
  ivec2 size = textureSize(veils, 0).xy;
  vec2 at = place.xy * vec2(size) - 0.5;
  vec2 share = at - floor(at);
  ivec2 low = clamp(ivec2(floor(at)), ivec2(0), size - 1), step = min(low + 1, size - 1) - low;
  int texels = asked ? 4 : 0;
  vec3 sum = vec3(asked ? 0.0 : 1.0);
  for (int i = 0; i < texels; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 weight = mix(1.0 - share, share, vec2(corner));
    sum += weight.x * weight.y * past_veil(texelFetch(veils, ivec3(low + corner * step, place.z), 0), depth);
  }
  return sum;
}

#endif
