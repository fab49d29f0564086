// Lights as bodies that a rasteriser draws, where lights are not culled for tiles [Sousa, Kasyan & Schulz 2011, "Secrets
// of CryENGINE 3 Graphics Technology"]. Vertices are made from their number alone: no buffer holds them.
#ifndef VEL_SHADING_LIGHT_VOLUMES_GLSL
#define VEL_SHADING_LIGHT_VOLUMES_GLSL

#include "shading/constants.glsl"
#include "shading/lang.glsl"
#include "shading/tile_culling.glsl"

// Bodies are turned on a lathe: quads between sectors of the turn and stacks of the profile.
const uint kVolumeSectors = 12u;
const uint kSphereStacks = 6u;
const uint kConeStacks = 2u;
const uint kSphereVertices = 432u;  // 6 kVolumeSectors kSphereStacks
const uint kConeVertices = 144u;    // 6 kVolumeSectors kConeStacks

// Bodies are so much larger than they need be, so that rounding leaves nothing of the light outside.
const float kVolumeSlack = 1e-3f;

// Spots up to this half angle, cos 45 degrees, are drawn as cones; wider ones as the spheres around them, which are
// smaller than a cone that ends in a plane.
const float kConeLeastCosine = 0.70710678f;

struct ScreenBounds {
  vec2 low, high;  // ndc; low >= high where nothing is on the screen
};

// Lateral over depth of the two lines from the eye that touch a circle. depth > radius.
FN vec2 tangent_slopes(float lateral, float depth, float radius) {
  require(depth > radius);
  float q = (depth - radius) * (depth + radius);
  float root = radius * sqrt(lateral * lateral + q);
  return vec2(lateral * depth - root, lateral * depth + root) / q;
}

// Of one axis: both ends at depth 1 (perspective) or in metres (orthographic), to ndc, cut at the screen's edges.
FN vec2 ndc_interval(vec2 ends, float scale, float offset) {
  vec2 ndc = (ends - vec2(offset)) / scale;
  return clamp(vec2(min(ndc.x, ndc.y), max(ndc.x, ndc.y)), -1.0f, 1.0f);
}

// The part of the screen that a sphere may be seen in: all of it where it reaches the eye. ndc_to_view, perspective: as
// view_position().
FN ScreenBounds sphere_screen_bounds(vec3 center_vs, float radius, vec4 ndc_to_view, float perspective) {
  float r = cull_radius_with_slack(center_vs, radius);
  float depth = -center_vs.z;
  ScreenBounds all;
  all.low = vec2(-1.0f);
  all.high = vec2(1.0f);
  if (depth + r < 0.0f) all.high = all.low;
  if (depth <= r) return all;
  vec2 x = perspective > 0.5f ? tangent_slopes(center_vs.x, depth, r) : vec2(center_vs.x - r, center_vs.x + r);
  vec2 y = perspective > 0.5f ? tangent_slopes(center_vs.y, depth, r) : vec2(center_vs.y - r, center_vs.y + r);
  x = ndc_interval(x, ndc_to_view.x, ndc_to_view.z);
  y = ndc_interval(y, ndc_to_view.y, ndc_to_view.w);
  ScreenBounds bounds;
  bounds.low = vec2(x.x, y.x);
  bounds.high = vec2(x.y, y.y);
  return bounds;
}

// Share of the screen.
FN float screen_share(IN(ScreenBounds) b) {
  vec2 size = max(b.high - b.low, vec2(0.0f));
  return 0.25f * size.x * size.y;
}

struct LatheCorner {
  float turn;  // radians about the axis
  uint stack;
};

// Two triangles a quad, counter-clockwise from outside where stacks rise along the axis.
FN LatheCorner lathe_corner(uint vertex) {
  uint corner = vertex % 6u;
  uint quad = vertex / 6u;
  uint next_sector = corner == 1u || corner == 2u || corner == 4u ? 1u : 0u;
  uint next_stack = corner == 2u || corner == 4u || corner == 5u ? 1u : 0u;
  LatheCorner c;
  // Modulo, so that the seam has the same bits from both sides.
  c.turn = float((quad % kVolumeSectors + next_sector) % kVolumeSectors) * (kTwoPi / float(kVolumeSectors));
  c.stack = quad / kVolumeSectors + next_stack;
  return c;
}

// A vertex of a body around the unit sphere. Its flat faces lie outside where the vertices are so far away: a chord of
// the profile comes nearer by the cosine of half a stack, and one of the turn by that of half a sector.
FN vec3 sphere_volume_point(uint vertex) {
  require(vertex < kSphereVertices);
  LatheCorner c = lathe_corner(vertex);
  float polar = kPi * (1.0f - float(c.stack) / float(kSphereStacks));
  float outside = (1.0f + kVolumeSlack) / (cos(kPi / float(kVolumeSectors)) * cos(kHalfPi / float(kSphereStacks)));
  float ring = c.stack == 0u || c.stack == kSphereStacks ? 0.0f : sin(polar);  // one pole, to the bit
  return outside * vec3(ring * cos(c.turn), ring * sin(c.turn), cos(polar));
}

// A vertex of a body around the unit sector about +z: what is within 1 of the origin and within the angle of the axis.
// cos_outer in [kConeLeastCosine, 1].
FN vec3 cone_volume_point(uint vertex, float cos_outer) {
  require(vertex < kConeVertices && cos_outer >= kConeLeastCosine && cos_outer <= 1.0f);
  LatheCorner c = lathe_corner(vertex);
  float apex = -kVolumeSlack;
  float base = 1.0f + kVolumeSlack;
  float tangent = sqrt(1.0f - cos_outer * cos_outer) / cos_outer;
  float rim = (base - apex) * tangent / cos(kPi / float(kVolumeSectors));
  float radius = c.stack == 1u ? rim : 0.0f;
  return vec3(radius * cos(c.turn), radius * sin(c.turn), c.stack == 0u ? apex : base);
}

#endif
