// Soft shadows from maps of depth: where taps lie, and how wide a penumbra is [Crytek, "Secrets of CryENGINE 3 Graphics
// Technology", 2011, presorted taps; Fernando 2005, "Percentage-Closer Soft Shadows", blocker search].
//
// A filter has two steps. The search looks at stored depths around the receiver, and averages the distances of those
// blockers that may hide a part of the light. The average gives rho, the width of the penumbra as a share of the widest
// one. Then the first m taps of a disc compare, m = rho^2 n: fewer and nearer ones where the shadow is sharp. Lengths
// across the map are in whatever unit the caller chooses, one unit a call.
#ifndef VEL_SHADING_SHADOW_FILTER_GLSL
#define VEL_SHADING_SHADOW_FILTER_GLSL

#include "shading/constants.glsl"
#include "shading/lang.glsl"

// Cosine and sine of the golden angle, pi (3 - sqrt(5)): turned by it again and again, directions never line up.
const float kGoldenAngleCosine = -0.737368878078320f;
const float kGoldenAngleSine = 0.675490294261524f;

// Fewer taps than this show as steps in the penumbra: the error at the edge of a half plane is up to 2 / m.
const uint kMinShadowTaps = 8u;

// The direction (unit) of the tap after one of direction `d`.
FN vec2 next_tap_direction(vec2 d) {
  return vec2(kGoldenAngleCosine * d.x - kGoldenAngleSine * d.y, kGoldenAngleSine * d.x + kGoldenAngleCosine * d.y);
}

// The direction of the first tap. noise: in [0, 1), a turn a pixel.
FN vec2 first_tap_direction(float noise) {
  return vec2(cos(kTwoPi * noise), sin(kTwoPi * noise));
}

// Radius of tap i of n in the unit disc [Vogel 1979]: even density, sorted, the first m within sqrt(m / n).
FN float disc_tap_radius(uint i, uint n) {
  require(i < n);
  return sqrt((float(i) + 0.5f) / float(n));
}

// Radius of tap i of n of the search, from `inner` to `outer`. Every other tap is evenly spread over the disc, as the
// rim of a wide penumbra hides little of it and is lost where few look there; those between crowd about the middle by a
// square law, where near blockers, which cast narrow penumbrae, are to be found.
FN float search_tap_radius(uint i, uint n, float inner, float outer) {
  require(i < n && inner <= outer);
  float x = (float(i) + 0.5f) / float(n);
  return inner + (outer - inner) * ((i & 1u) == 0u ? sqrt(x) : x * x);
}

// The same for lights, whose nearest casters may throw penumbrae far wider than the usual ones: where `widest` is larger than
// `usual`, every other tap goes on from the rim of the usual disc to the widest one, evenly by radius. 0 < usual <= widest.
FN float wide_search_tap_radius(uint i, uint n, float usual, float widest) {
  require(i < n && usual <= widest);
  float x = (float(i) + 0.5f) / float(n);
  return (i & 1u) == 0u ? max(usual * sqrt(x), widest * x) : usual * x * x;
}

// May a blocker hide a part of the light? It stands `offset` beside the way from the receiver to the light's middle;
// at its distance the light's cone has the radius `cone`. Without this test a wide search blurs what touches the
// ground, and finds the receiver's own slope. slack: what the map cannot resolve, about a texel and a half.
FN bool blocks_light(float offset, float cone, float slack) {
  return offset <= cone + slack;
}

// What stands beside the cone counts, too, up to this many times as far: it tells of an edge that may reach into the cone
// between the taps. Where none does the filter finds no shadow; where the search finds nothing there is none, so that a
// narrower one would lose the outer half of each penumbra.
const float kConeWidth = 3.0f;

// rho of a light far away (the sun): penumbrae grow with the distance of the blocker, up to the one at max_distance.
// Distances along the light, > 0, in one unit.
FN float penumbra_ratio_distant(float blocker_distance, float max_distance) {
  require(max_distance > 0.0f);
  return clamp(blocker_distance / max_distance, 0.0f, 1.0f);
}

// Radius of the penumbra at the receiver of a light of this radius: similar triangles over the blocker's edge.
// Depths from the light, 0 < blocker <= receiver.
FN float penumbra_radius_local(float receiver, float blocker, float light_radius) {
  require(blocker > 0.0f && blocker <= receiver);
  return light_radius * (receiver - blocker) / blocker;
}

// How many of n taps a penumbra of rho needs at the density of the widest one. rho in [0, 1].
FN uint reduced_tap_count(float rho, uint n) {
  require(rho >= 0.0f && rho <= 1.0f);
  return clamp(uint(ceil(rho * rho * float(n))), min(kMinShadowTaps, n), n);
}

// What to multiply the radii of the first m of n taps by, so that they fill a disc of radius rho. Without it the least
// count would widen sharp shadows.
FN float reduced_tap_scale(float rho, uint m, uint n) {
  require(m > 0u && m <= n);
  return rho * sqrt(float(n) / float(m));
}

// Blockers whose distances differ by more than this ratio are taken as two layers: of one mean, either would have a
// penumbra that is wrong by more than half of itself.
const float kLayerRatio = 2.0f;
// What is nearer than this share of the farthest one counts as there: its penumbra is nothing beside the other's.
const float kNearestLayer = 1.0f / 16.0f;

FN bool are_layered(float nearest, float farthest) {
  return farthest > kLayerRatio * nearest;
}

// The distance that parts two layers.
FN float layer_split(float nearest, float farthest) {
  return sqrt(max(nearest, kNearestLayer * farthest) * farthest);
}

// Rays from a receiver to points of a light, past two layers. Maps know one surface a texel: the near layer is not seen where
// the far one stands before it, and is taken to be there as it is elsewhere.
struct LayeredRays {
  float open;   // that pass the far layer
  float seen;   // of these, that pass the near one's place where the map sees it
  float lit;    // of these, that pass it
};

FN LayeredRays no_rays() {
  LayeredRays none;
  none.open = 0.0f;
  none.seen = 0.0f;
  none.lit = 0.0f;
  return none;
}

// Shares in [0, 1]: past_far: nothing stands beyond the split on the ray's way through the far layer; near_seen: nor does it
// on its way through the near layer; past_near: nothing at all stands there.
FN LayeredRays with_ray(IN(LayeredRays) rays, float past_far, float near_seen, float past_near) {
  LayeredRays sum;
  sum.open = rays.open + past_far;
  sum.seen = rays.seen + past_far * near_seen;
  sum.lit = rays.lit + past_far * min(near_seen, past_near);
  return sum;
}

FN float visibility_of(IN(LayeredRays) rays, uint count) {
  float past_near = rays.seen > 0.0f ? rays.lit / rays.seen : 1.0f;
  return rays.open * past_near / float(count);
}

#endif
