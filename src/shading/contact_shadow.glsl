// Shadows of what is near, found by a march through the picture's own depth ["Screen Space Self-Shadowing", Tatarchuk et
// al. 2012, Secrets of CryENGINE 3]: a ray towards the light that passes behind a surface is held to be blocked by it.
// Depths are view depths in metres; distances in the picture are in pixels.
#ifndef VEL_SHADING_CONTACT_SHADOW_GLSL
#define VEL_SHADING_CONTACT_SHADOW_GLSL

#include "shading/depth.glsl"
#include "shading/lang.glsl"

// The march starts this far above the surface, in pixels, where curved surfaces leave the plane that they are taken for.
const float kContactLift = 0.25f;

// Of a light with a map, contact shadows are what the map is too coarse for: no longer than so many of its texels, and of
// blockers no thicker than one. Longer ones find little more, thicker ones add what is not there: against the path tracer
// (docs/techniques/contact_shadows.md).
const float kContactTexels = 6.0f;

// Shadows fade over the last quarter of the ray, so that none ends at an edge of its own.
const float kContactFade = 0.25f;

// Shadows fade over this share of the picture's width before its edges, as nothing is known beyond.
const float kContactBorder = 0.02f;

// Only the light that gives more than half of a pixel's light throws a contact shadow there: there can be but one, whatever
// their number, and shadows of weaker ones are faint. They come in from that share on, to be whole at this one: so none
// begins or ends at a line where two lights are equally bright.
const float kContactWholeShare = 0.75f;

// Bits of a key that name a light: kMaxLights of upload/gpu_structs.glsl.
const uint kStrengthIndexBits = 14u;
// Luminance of keys: within what floats can tell from 0 and from infinity.
const float kLeastStrength = 1e-30f, kMostStrength = 1e30f;

// A light and how much it adds to a pixel, in one number whose order is that of what is added, to one part in 500: so the largest can
// be found in any order, also by blending. 0: it adds nothing.
FN float dominant_light_key(float luminance, uint index) {
  require(index < 1u << kStrengthIndexBits);
  if (luminance < kLeastStrength) return 0.0f;
  uint strength = floatBitsToUint(min(luminance, kMostStrength)) >> kStrengthIndexBits << kStrengthIndexBits;
  return uintBitsToFloat(strength | index);
}

// The light of a key.
FN uint light_of_key(float key) {
  return floatBitsToUint(key) & ((1u << kStrengthIndexBits) - 1u);
}

// How much of its contact shadow a light throws which adds `light` to a pixel of `all`, luminances.
FN float contact_weight(float light, float all) {
  return clamp((light - 0.5f * all) / ((kContactWholeShare - 0.5f) * max(all, kLeastStrength)), 0.0f, 1.0f);
}

// Height of a pixel at a view depth, metres. ndc_to_view, perspective: as view_position(); height: of the picture, pixels.
FN float pixel_footprint(float view_depth, vec4 ndc_to_view, float perspective, float height) {
  return 2.0f * abs(ndc_to_view.y) / height * mix(1.0f, view_depth, perspective);
}

// How many samples a ray takes that is so many pixels long: no more than it passes.
FN uint contact_steps(float pixels, uint most) {
  require(most > 0u);
  return uint(clamp(floor(pixels) + 1.0f, 1.0f, float(most)));
}

// The change of device depth from one pixel to the next, from the differences to both neighbours: the smaller one, as
// the other may reach across an edge. Device depth of a plane is linear in the picture. 0: nothing was drawn there.
FN float depth_slope(float before, float at, float after) {
  float left = at - before, right = after - at;
  if (before == 0.0f) return after == 0.0f ? 0.0f : right;
  return after == 0.0f || abs(left) < abs(right) ? left : right;
}

// Is a ray at depth `ray` behind a surface at depth `surface`, yet not behind what that surface belongs to?
FN bool contact_blocked(float ray, float surface, float thickness) {
  return ray > surface && ray < surface + thickness;
}

// How dark a blocker at this share of the ray's length is.
FN float contact_darkness(float along) {
  return clamp((1.0f - along) / kContactFade, 0.0f, 1.0f);
}

// What the nearness of the picture's edges leaves of it. pixel: where the blocker is seen; size: of the picture.
FN float contact_border(vec2 pixel, vec2 size) {
  vec2 inside = min(pixel, size - pixel);
  return clamp(min(inside.x, inside.y) / (kContactBorder * size.x), 0.0f, 1.0f);
}

#endif
