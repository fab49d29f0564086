#version 460
#extension GL_GOOGLE_include_directive : require

#include "bake/environment_mip_io.glsl"
#include "bake/round_to_half.glsl"

// One texel of the smaller mip a thread: the mean of its four by solid angle, so that every mip holds the same power.

layout(local_size_x = 64) in;

void main() {
  uint size = uint(imageSize(smaller).x);
  uint texel = gl_GlobalInvocationID.x;
  if (texel >= 6u * size * size) return;
  ivec3 place = ivec3(texel % size, texel / size % size, texel / (size * size));
  vec3 sum = vec3(0.0f);
  float weight_sum = 0.0f;
  for (int child = 0; child < 4; ++child) {
    ivec3 from = ivec3(2 * place.xy + ivec2(child & 1, child >> 1), place.z);
    vec2 st = (vec2(from.xy) + vec2(0.5f)) / float(size) - vec2(1.0f);
    float inverse_distance = inversesqrt(1.0f + dot(st, st));
    float weight = inverse_distance * inverse_distance * inverse_distance;
    sum += weight * imageLoad(larger, from).rgb;
    weight_sum += weight;
  }
  imageStore(smaller, place, vec4(round_to_half(sum / weight_sum), 1.0f));
}
