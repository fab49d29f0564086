#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

// Tiled deferred lighting [Schulz 2014, Ryse]: one compute shader finds the lights of each 16x16 tile and shades it.
// A tile keeps a light when its sphere passes the side planes, the box and the 32-slice depth mask, and a spot when its
// cone passes as well; the list is a bit mask in light order, so that sums are the same on every run and equal to a loop
// over all lights. Transparent surfaces get a list of their own.

#include "passes/gbuffer/read.glsl"
#include "passes/lighting/light_contact.glsl"
#include "passes/lighting/lighting_own_io.glsl"
#include "passes/lighting/read.glsl"
#include "shading/constants.glsl"
#include "shading/tile_culling.glsl"

shared uint tile_min, tile_max;      // bits of positive floats, which order as the floats do
shared uint tile_depth_mask;
shared uint tile_open;               // 1: some pixel shows no opaque surface
shared uint tile_lights[kMaxLights / 32u];

// tile_sphere: around the tile, in world space.
bool light_reaches(TileVolume tile, vec4 tile_sphere, uint index) {
  vec4 bounds = light_bounds[index];
  if (!tile_overlaps_sphere(tile, bounds.xyz, bounds.w)) return false;
  float depth = -bounds.z;
  if (index >= light_ranges.first_spot) {
    GpuLight l = lights[index];
    if (!cone_overlaps_sphere(l.position_range.xyz, l.direction.xyz, l.cone.z, tile_sphere)) return false;
  }
  return (depth_mask_range(depth - bounds.w, depth + bounds.w, tile.z_min, tile.z_max) & tile_depth_mask) != 0u;
}

const uint kTilePixels = kTileSize * kTileSize;

uvec2 tile_pixel(uint i) {
  return gl_WorkGroupID.xy * kTileSize + uvec2(i % kTileSize, i / kTileSize);
}

// The tile's depth range, and which of 32 slices of it hold a surface.
void find_tile_depths() {
  uint thread = gl_LocalInvocationIndex;
  if (thread == 0u) {
    tile_min = 0x7f7fffffu;
    tile_max = 0u;
    tile_depth_mask = 0u;
    tile_open = 0u;
  }
  barrier();
  float nearest = uintBitsToFloat(0x7f7fffffu), farthest = 0.0;
  bool open = false;
  for (uint i = thread; i < kTilePixels; i += gl_WorkGroupSize.x) {
    uvec2 pixel = tile_pixel(i);
    float depth = linear_depth_at(ivec2(pixel));
    if (depth > 0.0) {
      nearest = min(nearest, depth);
      farthest = max(farthest, depth);
    } else if (all(lessThan(vec2(pixel), frame.size.xy))) {
      open = true;
    }
  }
  if (open) atomicOr(tile_open, 1u);
  atomicMin(tile_min, floatBitsToUint(nearest));
  atomicMax(tile_max, floatBitsToUint(farthest));
  barrier();
  uint slices = 0u;
  for (uint i = thread; i < kTilePixels; i += gl_WorkGroupSize.x) {
    float depth = linear_depth_at(ivec2(tile_pixel(i)));
    if (depth > 0.0) slices |= depth_mask_bit(depth, uintBitsToFloat(tile_min), uintBitsToFloat(tile_max));
  }
  atomicOr(tile_depth_mask, slices);
}

// May a light reach transparent surfaces of a tile? before: all of it that stands before opaque ones.
bool light_reaches_before(TileVolume before, vec2 ndc_min, vec2 ndc_max, uint index) {
  bool asked_everywhere = !kTiled && kPunctual == kPunctualHere;
  if (asked_everywhere) return true;
  vec4 bounds = light_bounds[index];
  if (!tile_overlaps_sphere_no_near(before, bounds.xyz, bounds.w)) return false;
  if (index < light_ranges.first_spot) return true;
  GpuLight l = lights[index];
  mat3 rotation = view_rotation();
  vec3 position_vs = rotation * l.position_range.xyz + frame.view_from_world[3].xyz;
  return spot_reaches_before(bounds, position_vs, rotation * l.direction.xyz, l.cone.z,
                             ndc_min, ndc_max, before.z_max, frame.ndc_to_view, frame.perspective);
}

// The list for transparent surfaces: they stand before all opaque ones, and before the sky at any depth.
void write_forward_list(vec2 ndc_min, vec2 ndc_max, uint words) {
  float z_max = tile_open != 0u ? kUnboundedRadius : uintBitsToFloat(tile_max);
  TileVolume before = tile_volume(ndc_min, ndc_max, 0.0, z_max, frame.ndc_to_view, frame.perspective);
  uint base = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * words;
  for (uint word = gl_LocalInvocationIndex; word < words; word += gl_WorkGroupSize.x) {
    uint bits = 0u;
    for (uint bit = 0u; bit < 32u && word * 32u + bit < light_ranges.count; ++bit)
      if (light_reaches_before(before, ndc_min, ndc_max, word * 32u + bit)) bits |= 1u << bit;
    own_forward_lists[base + word] = bits;
  }
}

void find_tile_lights() {
  uint thread = gl_LocalInvocationIndex;
  uint words = (light_ranges.count + 31u) / 32u;
  for (uint i = thread; i < words; i += gl_WorkGroupSize.x) tile_lights[i] = 0u;
  find_tile_depths();
  barrier();
  float z_min = uintBitsToFloat(tile_min), z_max = uintBitsToFloat(tile_max);
  bool empty = tile_max == 0u;

  vec2 corner = vec2(gl_WorkGroupID.xy * kTileSize);
  vec2 ndc_min = corner * frame.size.zw * 2.0 - 1.0;
  vec2 ndc_max = (corner + float(kTileSize)) * frame.size.zw * 2.0 - 1.0;
  TileVolume tile = tile_volume(ndc_min, ndc_max, empty ? 0.0 : z_min, z_max, frame.ndc_to_view, frame.perspective);
  vec4 sphere = tile_bounding_sphere(tile);
  vec4 sphere_ws = vec4(transpose(view_rotation()) * sphere.xyz + frame.eye.xyz, sphere.w);
  for (uint i = thread; i < light_ranges.count && !empty; i += gl_WorkGroupSize.x)
    if (light_reaches(tile, sphere_ws, i)) atomicOr(tile_lights[i / 32u], 1u << (i % 32u));

  if (kForwardLists) write_forward_list(ndc_min, ndc_max, words);
  barrier();
}

uint tile_light_word(uint word) {
  return kTiled ? tile_lights[word] : 0xffffffffu;
}

vec4 background(vec2 ndc) {
  if (environment.turn.w == 0.0) return environment.background;
  vec3 far_vs = view_position(ndc, 1.0, frame.ndc_to_view, 1.0);
  // Orthographic views look along one direction: the background is then a single point of the environment.
  vec3 direction_vs = frame.perspective > 0.5 ? normalize(far_vs) : vec3(0.0, 0.0, -1.0);
  vec3 direction_ws = transpose(view_rotation()) * direction_vs;
  vec2 uv = equirect_uv(to_environment(direction_ws));
  vec3 radiance = textureLod(sampler2D(background_map, equirect_sampler), uv, 0.0).rgb * environment.turn.x;
  return vec4(min(radiance, kLargestHalf), 1.0);
}

// What punctual lights add. light_volumes has kept the sum and the key of the light that adds the most, which contact
// shadows need.
PunctualLight punctual_light(ShadingPoint p, ivec2 pixel) {
  if (kPunctual == kPunctualHere) return punctual_lights(p);
  if (kPunctual == kNoPunctual) return PunctualLight(vec3(0.0), vec3(0.0), 0.0);
  vec4 texel = texelFetch(volume_light, pixel, 0);
  if (kContactSteps == 0u || texel.a == 0.0) return PunctualLight(texel.rgb, vec3(0.0), 0.0);
  return PunctualLight(texel.rgb, light_of(p, light_of_key(texel.a)), texel.a);
}

void shade(uvec2 at) {
  ivec2 pixel = ivec2(at);
  float depth = linear_depth_at(ivec2(at));
  if (depth == 0.0) {
    imageStore(hdr, pixel, background(ndc_of_pixel(pixel)));
    return;
  }
  uint material_class = gbuffer_class(pixel);
  if (material_class == kClassUnlit) return;

  ShadingPoint p = gbuffer_point(pixel, depth, material_class);
  vec3 light = imageLoad(hdr, pixel).rgb + environment_light(p);
  PunctualLight punctual = punctual_light(p, pixel);
  light += punctual.sum;
  if (kPunctual != kNoPunctual)
    light = max(light - hidden_by_contact(p, pixel, depth, punctual, light), vec3(0.0));  // rounding
  imageStore(hdr, pixel, vec4(min(light, kLargestHalf), 1.0));
}

void main() {
  if ((kPunctual == kPunctualHere && kTiled) || kForwardLists) find_tile_lights();
  for (uint i = gl_LocalInvocationIndex; i < kTilePixels; i += gl_WorkGroupSize.x) {
    uvec2 pixel = tile_pixel(i);
    if (all(lessThan(vec2(pixel), frame.size.xy))) shade(pixel);
  }
}
