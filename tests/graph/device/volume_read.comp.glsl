#version 460
#extension GL_EXT_samplerless_texture_functions : require
// Copies all mips of a volume into a buffer, one after the other.

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(set = 0, binding = 0) uniform utexture3D volume;
layout(set = 0, binding = 1) writeonly buffer Values {
  uint values[];
};

void main() {
  const ivec3 place = ivec3(gl_GlobalInvocationID);
  uint first = 0u;
  for (int mip = 0; mip < textureQueryLevels(volume); ++mip) {
    const ivec3 size = textureSize(volume, mip);
    if (all(lessThan(place, size)))
      values[first + uint(place.x + size.x * (place.y + size.y * place.z))] = texelFetch(volume, place, mip).x;
    first += uint(size.x * size.y * size.z);
  }
}
