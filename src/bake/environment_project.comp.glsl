#version 460
#extension GL_GOOGLE_include_directive : require

#include "bake/environment_project_io.glsl"
#include "bake/round_to_half.glsl"
#include "shading/environment.glsl"

// One texel of the cube a thread: the mean radiance over its solid angle, by taps x taps bilinear reads of the picture.

layout(local_size_x = 64) in;

void main() {
  uint size = uint(imageSize(cube).x);
  uint texel = gl_GlobalInvocationID.x;
  if (texel >= 6u * size * size) return;
  ivec3 place = ivec3(texel % size, texel / size % size, texel / (size * size));
  vec3 sum = vec3(0.0f);
  float weight_sum = 0.0f;
  for (uint tap = 0u; tap < push.taps * push.taps; ++tap) {
    vec2 offset = (vec2(tap % push.taps, tap / push.taps) + vec2(0.5f)) / float(push.taps);
    vec2 uv = (vec2(place.xy) + offset) / float(size);
    // Solid angle of a piece of the face falls with the cube of its distance.
    vec2 st = 2.0f * uv - vec2(1.0f);
    float inverse_distance = inversesqrt(1.0f + dot(st, st));
    float weight = inverse_distance * inverse_distance * inverse_distance;
    sum += weight * textureLod(equirect, equirect_uv(cube_direction(uint(place.z), uv)), float(push.mip)).rgb;
    weight_sum += weight;
  }
  vec4 value = vec4(round_to_half(sum / weight_sum), 1.0f);
  imageStore(cube, place, value);
  imageStore(mirror, place, value);
}
