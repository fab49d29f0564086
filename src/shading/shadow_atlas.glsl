// Maps of depth of point and spot lights, side by side in one image [Crytek, "Secrets of CryENGINE 3 Graphics
// Technology", 2011: six projectors a point light, scaled by their screen coverage, packed into one texture].
//
// A view looks from the light along an axis. Tangents are places on the plane at distance 1: x / depth. Depth is
// reversed and without end: near / distance along the axis, so that it is linear in tangents on every plane.
#ifndef VEL_SHADING_SHADOW_ATLAS_GLSL
#define VEL_SHADING_SHADOW_ATLAS_GLSL

#include "shading/lang.glsl"
#include "shading/lights.glsl"

// Spot lights whose cone has at least this cosine, 60 degrees from the axis, have one view along their axis. Wider ones
// have six as points do: towards 90 degrees one view would spend nearly all of its texels on the rim.
const float kOneViewCosine = 0.5f;

// The widest filter, as a share of the view's own half width: blockers whose penumbra is wider, seen from the light, cast
// this one. Wider views spend most of their texels beyond what they serve.
const float kWidestKernel = 1.0f;
// Filters are wider than the penumbra of the nearest caster, so that searches find edges that end beside it.
const float kKernelMargin = 1.5f;
// A kernel is rounded up to a multiple of this: what rounding does to places is no reason to draw a map again.
const float kKernelStep = 1.0f / 16.0f;

// Texels that comparisons reach to beyond the place they are made at: one of the bilinear filter, half of rounding.
const float kShadowBorder = 1.5f;

struct ShadowView {
  vec4 right;    // xyz: unit axis, times atlas coordinates a tangent; w: x of the axis in the atlas
  vec4 down;     // the same for y
  vec4 forward;  // xyz: unit axis; w: distance of the near plane, metres
  vec4 tile;     // x: half its side less half a texel, in atlas coordinates, 0: nothing stands in the view's way;
                 // y: widest filter and z: a texel, in tangents; w: 1 / depth of the nearest BLEND
                 // surface along the axis, metres, 0: there is none
  vec4 translucent;  // atlas coordinates, lowest and highest, at which filters may meet such
};
CHECK_LAYOUT(ShadowView, right, 0);
CHECK_LAYOUT(ShadowView, forward, 32);
CHECK_LAYOUT(ShadowView, tile, 48);
CHECK_LAYOUT(ShadowView, translucent, 64);

FN bool has_one_view(IN(GpuLight) l) {
  return is_spot(l) && l.cone.z >= kOneViewCosine;
}

// Which of six views sees a place: by the axis on which it is farthest out; +x, -x, +y, -y, +z, -z.
FN uint shadow_face(vec3 from_light) {
  vec3 a = abs(from_light);
  if (a.x >= a.y && a.x >= a.z) return from_light.x >= 0.0f ? 0u : 1u;
  if (a.y >= a.z) return from_light.y >= 0.0f ? 2u : 3u;
  return from_light.z >= 0.0f ? 4u : 5u;
}

// The tangent that a view of `size` texels ends at, so that filters of places within half_tangent stay inside.
// kernel: the widest filter in tangents, texels aside.
FN float widened_tangent(float half_tangent, float kernel, float size) {
  require(size > 2.0f * kShadowBorder);
  return (half_tangent + kernel) / (1.0f - 2.0f * kShadowBorder / size);
}

// The widest filter of a view, tangents. nearest: distance from the light to its nearest caster, > 0; a blocker there
// casts, seen from the light, a penumbra of light_radius / nearest at most.
FN float widest_kernel(float half_tangent, float light_radius, float nearest) {
  require(nearest > 0.0f);
  float wanted = kKernelStep * ceil(kKernelMargin * light_radius / nearest / kKernelStep);
  return min(wanted, kWidestKernel * half_tangent);
}

// log2 of the texels a side that a view deserves which lights `pixels` of the picture: as many texels as pixels, times
// density squared ["logarithmic density", Crytek 2011: powers of two, so that tiles pack without gaps].
FN float wanted_tile_octave(float pixels, float density) {
  require(density > 0.0f);
  return 0.5f * log2(max(pixels, 1.0f)) + log2(density);
}

// Distance along the view's axis.
FN float shadow_view_depth(IN(ShadowView) view, vec3 from_light) {
  return max(dot(vec3(view.forward.x, view.forward.y, view.forward.z), from_light), view.forward.w);
}

// Where a place is seen in the atlas. view_depth: shadow_view_depth() of it.
FN vec2 shadow_view_uv(IN(ShadowView) view, vec3 from_light, float view_depth) {
  return vec2(view.right.w, view.down.w) + vec2(dot(vec3(view.right.x, view.right.y, view.right.z), from_light),
                                                dot(vec3(view.down.x, view.down.y, view.down.z), from_light)) /
                                               view_depth;
}

// May a BLEND surface stand between the light and a place? view_depth, uv: of the place.
FN bool may_be_translucent(IN(ShadowView) view, float view_depth, vec2 uv) {
  bool inside = uv.x > view.translucent.x && uv.y > view.translucent.y && uv.x < view.translucent.z && uv.y < view.translucent.w;
  return inside && view_depth * view.tile.w > 1.0f;
}

// A place in the atlas, moved into the tile: what neighbours store is never read.
FN vec2 clamp_to_tile(IN(ShadowView) view, vec2 uv) {
  vec2 center = vec2(view.right.w, view.down.w);
  return center + clamp(uv - center, vec2(-view.tile.x), vec2(view.tile.x));
}

#endif
