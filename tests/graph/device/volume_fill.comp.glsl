#version 460
// Each texel of a volume: its place, packed, plus a number.

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(set = 0, binding = 0, r32ui) uniform writeonly uimage3D volume;

layout(push_constant) uniform Push {
  uint number;
};

void main() {
  const ivec3 place = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(place, imageSize(volume)))) return;
  imageStore(volume, place, uvec4(uint(place.x + 16 * place.y + 256 * place.z) + number));
}
