#version 460
#extension GL_GOOGLE_include_directive : require

#include "bake/round_to_half.glsl"
#include "shading/environment.glsl"

// One texel of the cube a thread: the mean radiance over its solid angle, by taps x taps bilinear reads of the picture.

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) uniform sampler2D equirect;
layout(set = 0, binding = 1, rgba16f) writeonly uniform image2DArray cube;
layout(set = 0, binding = 2, rgba16f) writeonly uniform image2DArray mirror;
layout(push_constant) uniform Push { uint taps, mip; };

void main() {
  uint size = uint(imageSize(cube).x);
  uint texel = gl_GlobalInvocationID.x;
  if (texel >= 6u * size * size) return;
  ivec3 place = ivec3(texel % size, texel / size % size, texel / (size * size));
  vec3 sum = vec3(0.0f);
  float weight_sum = 0.0f;
  for (uint tap = 0u; tap < taps * taps; ++tap) {
    vec2 offset = (vec2(tap % taps, tap / taps) + vec2(0.5f)) / float(taps);
    vec2 uv = (vec2(place.xy) + offset) / float(size);
    // Solid angle of a piece of the face falls with the cube of its distance.
    vec2 st = 2.0f * uv - vec2(1.0f);
    float inverse_distance = inversesqrt(1.0f + dot(st, st));
    float weight = inverse_distance * inverse_distance * inverse_distance;
    sum += weight * textureLod(equirect, equirect_uv(cube_direction(uint(place.z), uv)), float(mip)).rgb;
    weight_sum += weight;
  }
  vec4 value = vec4(round_to_half(sum / weight_sum), 1.0f);
  imageStore(cube, place, value);
  imageStore(mirror, place, value);
}
