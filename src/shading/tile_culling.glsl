// Which lights may reach a screen tile. Conservative: a light that reaches a point of the tile is never refused.
// View space as view_position() gives it: x right, y up, looking along -z. Depths z are positive metres.
#ifndef VEL_SHADING_TILE_CULLING_GLSL
#define VEL_SHADING_TILE_CULLING_GLSL

#include "shading/depth.glsl"
#include "shading/lang.glsl"
#include "shading/lights.glsl"

// fp32 rounding of the products below, relative to the size of what is compared: a dozen steps of 2^-24.
const float kCullSlack = 1e-6f;

struct TileVolume {
  vec4 planes[4];  // left, right, lower, upper; xyz: inward unit normal; dot(n, p) + w >= 0 inside
  vec3 box_min, box_max;
  float z_min, z_max;  // depth of the nearest and the farthest surface
};

// Inward plane of the side at `edge` along an axis, unit x or y (perspective: at depth 1). side: +1 lower, -1 upper.
FN vec4 tile_side_plane(vec3 axis, float edge, float side, float perspective) {
  float slope = edge * perspective;
  float scale = side * inversesqrt(1.0f + slope * slope);
  return vec4((axis + vec3(0.0f, 0.0f, slope)) * scale, -edge * (1.0f - perspective) * scale);
}

// The part of the view between two corners of the screen and two depths.
// ndc_min <= ndc_max, 0 <= z_min <= z_max; ndc_to_view, perspective: as view_position().
FN TileVolume tile_volume(vec2 ndc_min, vec2 ndc_max, float z_min, float z_max, vec4 ndc_to_view, float perspective) {
  require(z_min >= 0.0f && z_min <= z_max);
  vec2 a = view_position_xy(ndc_min, 1.0f, ndc_to_view, perspective);
  vec2 b = view_position_xy(ndc_max, 1.0f, ndc_to_view, perspective);
  vec2 low = min(a, b);
  vec2 high = max(a, b);
  float scale_near = mix(1.0f, z_min, perspective);
  float scale_far = mix(1.0f, z_max, perspective);
  vec2 box_low = min(low * scale_near, low * scale_far);
  vec2 box_high = max(high * scale_near, high * scale_far);

  vec3 x_axis = vec3(1.0f, 0.0f, 0.0f);
  vec3 y_axis = vec3(0.0f, 1.0f, 0.0f);
  TileVolume t;
  t.planes[0] = tile_side_plane(x_axis, low.x, 1.0f, perspective);
  t.planes[1] = tile_side_plane(x_axis, high.x, -1.0f, perspective);
  t.planes[2] = tile_side_plane(y_axis, low.y, 1.0f, perspective);
  t.planes[3] = tile_side_plane(y_axis, high.y, -1.0f, perspective);
  t.box_min = vec3(box_low, -z_max);
  t.box_max = vec3(box_high, -z_min);
  t.z_min = z_min;
  t.z_max = z_max;
  return t;
}

FN float cull_radius_with_slack(vec3 center_vs, float radius) {
  return radius + kCullSlack * (radius + length(center_vs));
}

FN bool tile_planes_overlap_sphere(IN(TileVolume) t, vec3 center_vs, float radius) {
  bool inside = true;
  for (uint i = 0u; i < 4u; ++i) {
    vec4 plane = t.planes[i];
    inside = inside && dot(vec3(plane.x, plane.y, plane.z), center_vs) + plane.w >= -radius;
  }
  return inside;
}

// Side planes and box together: each alone lets through what the other refuses [Schulz 2014 names the complaint;
// measured, planes alone keep twice too many lights in shallow tiles]. The box holds the depth test.
FN bool tile_overlaps_sphere(IN(TileVolume) t, vec3 center_vs, float radius) {
  float r = cull_radius_with_slack(center_vs, radius);
  vec3 outside = max(max(t.box_min - center_vs, center_vs - t.box_max), vec3(0.0f));
  return dot(outside, outside) <= r * r && tile_planes_overlap_sphere(t, center_vs, r);
}

// For the lists of transparent surfaces, which lie anywhere between the eye and z_max.
FN bool tile_overlaps_sphere_no_near(IN(TileVolume) t, vec3 center_vs, float radius) {
  float r = cull_radius_with_slack(center_vs, radius);
  float depth = -center_vs.z;
  return depth + r >= 0.0f && depth - r <= t.z_max && tile_planes_overlap_sphere(t, center_vs, r);
}

// A tile's depth range in 32 equal cells ["2.5D culling", Harada 2012; Schulz 2014]: a light in the empty space between
// a near and a far surface is refused. Monotone in z, also after rounding, so that ranges cover what they should.
FN uint depth_cell(float z, float z_min, float z_max) {
  float cell = (z - z_min) / max(z_max - z_min, 1e-20f) * 32.0f;
  return uint(clamp(cell, 0.0f, 31.0f));
}

// The bit of a surface at depth z in [z_min, z_max].
FN uint depth_mask_bit(float z, float z_min, float z_max) {
  return 1u << depth_cell(z, z_min, z_max);
}

// The bits of a light from depth l_min to l_max; 0 where it misses the range.
FN uint depth_mask_range(float l_min, float l_max, float z_min, float z_max) {
  if (l_max < z_min || l_min > z_max) return 0u;
  uint first = depth_cell(l_min, z_min, z_max);
  uint last = depth_cell(l_max, z_min, z_max);
  return (0xffffffffu << first) & (0xffffffffu >> (31u - last));
}

// A sphere (xyz centre, w radius) around the tile's box, in view space.
FN vec4 tile_bounding_sphere(IN(TileVolume) t) {
  return vec4(0.5f * (t.box_min + t.box_max), 0.5f * length(t.box_max - t.box_min));
}

// May a spot's cone, however long, reach into a sphere (xyz centre, w radius)? axis: unit. cos_outer: not negative.
FN bool cone_overlaps_sphere(vec3 apex, vec3 axis, float cos_outer, vec4 sphere) {
  vec3 way = vec3(sphere.x, sphere.y, sphere.z) - apex;
  float along = dot(way, axis);
  float across = length(cross(way, axis));
  float sin_outer = sqrt(max(1.0f - cos_outer * cos_outer, 0.0f));
  // From the centre to the cone's side, which is less than to the cone itself where the centre lies behind the apex.
  float outside = cos_outer * across - sin_outer * along;
  float r = sphere.w + kCullSlack * (sphere.w + length(apex) + length(way));
  return outside <= r && along >= -r;
}

// Parts that a tile's way through a spot's sphere is cut into. One alone is as long as the cone and meets it nearly always;
// of these eight, tests/unit/shading/tile_culling_test.cpp counts how many meet it in vain.
const uint kSpotSlices = 8u;

// May a spot reach anything of a tile between the eye and z_max? bounds: its sphere, view space, xyz centre, w radius. apex,
// axis: view space, the latter unit; cos_outer: not negative. ndc_min to perspective: as tile_volume().
FN bool spot_reaches_before(vec4 bounds, vec3 apex, vec3 axis, float cos_outer, vec2 ndc_min, vec2 ndc_max, float z_max,
                            vec4 ndc_to_view, float perspective) {
  vec3 center = vec3(bounds.x, bounds.y, bounds.z);
  float radius = cull_radius_with_slack(center, bounds.w);
  float from = clamp(-center.z - radius, 0.0f, z_max), to = clamp(-center.z + radius, 0.0f, z_max);
  bool reached = false;
  for (uint i = 0u; i < kSpotSlices; ++i) {
    float z_from = mix(from, to, float(i) / float(kSpotSlices));
    float z_to = mix(from, to, float(i + 1u) / float(kSpotSlices));
    TileVolume part = tile_volume(ndc_min, ndc_max, z_from, max(z_from, z_to), ndc_to_view, perspective);
    vec4 sphere = tile_bounding_sphere(part);
    bool near_enough = length(vec3(sphere.x, sphere.y, sphere.z) - center) <= sphere.w + radius;
    reached = reached || (near_enough && cone_overlaps_sphere(apex, axis, cos_outer, sphere));
  }
  return reached;
}

// Smallest sphere (xyz centre, w radius) around a spot light's cone, cut at `range` from its apex. axis: unit.
// Up to 45 degrees the sphere passes through the apex, beyond that the rim is its equator.
FN vec4 spot_bounding_sphere(vec3 apex, vec3 axis, float range, float cos_outer) {
  // A sphere of this size through the apex would lose the apex to rounding.
  if (range >= kUnboundedRadius) return vec4(apex, kUnboundedRadius);
  float c = clamp(cos_outer, 0.0f, 1.0f);
  bool narrow = c * c >= 0.5f;
  float center = narrow ? 0.5f * range / c : range * c;
  float radius = narrow ? center : range * sqrt(1.0f - c * c);
  return vec4(apex + axis * center, radius + kCullSlack * (radius + length(apex)));
}

#endif
