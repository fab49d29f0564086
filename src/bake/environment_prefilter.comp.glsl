#version 460
#extension GL_GOOGLE_include_directive : require

#include "bake/environment_prefilter_io.glsl"
#include "bake/round_to_half.glsl"
#include "shading/environment.glsl"

// One texel of a level a thread: the mean radiance that its lobe gathers, over the cells of cut_lobe().

layout(local_size_x = 64) in;

void main() {
  uint size = uint(imageSize(level).x);
  uint texel = gl_GlobalInvocationID.x;
  if (texel >= 6u * size * size) return;
  ivec3 place = ivec3(texel % size, texel / size % size, texel / (size * size));
  vec3 axis = cube_direction(uint(place.z), (vec2(place.xy) + vec2(0.5f)) / float(size));
  vec3 tangent = from_tangent_space(vec3(1.0f, 0.0f, 0.0f), axis);
  vec3 bitangent = cross(axis, tangent);
  vec3 sum = vec3(0.0f);
  for (uint i = push.begin; i < push.end; ++i) {
    vec4 s = samples[i];
    float z = sqrt(max(1.0f - s.x * s.x - s.y * s.y, 0.0f));
    sum += s.w * textureLod(source, s.x * tangent + s.y * bitangent + z * axis, s.z).rgb;
  }
  imageStore(level, place, vec4(round_to_half(sum), 1.0f));
}
