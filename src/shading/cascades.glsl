// Maps of depth from a sun, one inside the other, and which of them a point is looked up in.
//
// All maps of a sun share their axes, which are fixed in the world: light space is x to the right and y down in the
// map, z towards the sun, in metres, with its origin at world space's. Depth is reversed: 1 nearest to the sun.
#ifndef VEL_SHADING_CASCADES_GLSL
#define VEL_SHADING_CASCADES_GLSL

#include "shading/lang.glsl"

const uint kMaxCascades = 6u;

// The share of a map's half side, along its borders and its far end, over which the next one takes over.
const float kCascadeBlend = 0.1f;

// One map.
struct Cascade {
  vec4 place;   // uv = x xy_ls + (y, z); w: what filters need around a point, uv
  vec4 depth;   // depth = x z_ls + y; z: 1 / x, the metres that the depths span; w: side of a texel, metres
  vec4 soft;    // x: radius of the widest penumbra, uv; y: distance of the blockers that cast it, metres; z: texel, uv;
                // w: the least distance that stored depths tell apart, metres, where they are coarse; else 0
};

// All that a shader knows of the sun's maps.
struct SunShadows {
  vec4 axis_x;          // xyz: unit, light space's in world axes; w: how far beside its plane a surface is seen, pixels
  vec4 axis_y;          // xyz: unit
  vec4 axis_z;          // xyz: unit, towards the sun; w: normal offset, texels
  Cascade cascades[6];  // kMaxCascades, near to far; GLSL 4.60 and C++ agree on a literal only
  uint cascade_count;
  uint translucent;     // bit i: BLEND surfaces stand in map i's way of light
};
CHECK_LAYOUT(SunShadows, cascades, 48);
CHECK_LAYOUT(SunShadows, cascade_count, 336);
CHECK_LAYOUT(SunShadows, translucent, 340);

FN vec3 to_light_space(IN(SunShadows) sun, vec3 v) {
  return vec3(dot(vec3(sun.axis_x.x, sun.axis_x.y, sun.axis_x.z), v),
              dot(vec3(sun.axis_y.x, sun.axis_y.y, sun.axis_y.z), v),
              dot(vec3(sun.axis_z.x, sun.axis_z.y, sun.axis_z.z), v));
}

// Where a point of light space lies in a map: u, v, depth.
FN vec3 shadow_coord(IN(Cascade) c, vec3 p_ls) {
  return vec3(p_ls.x * c.place.x + c.place.y, p_ls.y * c.place.x + c.place.z, p_ls.z * c.depth.x + c.depth.y);
}

// Planes that light grazes at less than this sine are taken as tilted by as much.
const float kLeastSunGrazing = 0.02f;

// How depth rises by u and v along a plane. n_ls: its normal, unit, light space, of the lit side.
FN vec2 cascade_slope(IN(Cascade) c, vec3 n_ls) {
  return -vec2(n_ls.x, n_ls.y) / max(n_ls.z, kLeastSunGrazing) * (c.depth.x / c.place.x);
}

// How much of a point's shadow comes from this map rather than the next one: 1 inside, falling to 0 where filters would
// leave the map, and at its far end; nearer to the sun than the map begins there is nothing to be shadowed. A point takes
// the first map whose weight is above a number in [0, 1): 0.5, or noise for a soft change.
FN float cascade_weight(IN(Cascade) c, vec3 place) {
  float sideways = 1.0f - 2.0f * c.place.w - 2.0f * max(abs(place.x - 0.5f), abs(place.y - 0.5f));
  float from_end = 2.0f * place.z * c.depth.z * c.place.x;
  float inside = place.z <= 1.0f ? min(sideways, from_end) : 0.0f;
  return clamp(inside / kCascadeBlend, 0.0f, 1.0f);
}

#endif
