#version 460
#extension GL_EXT_samplerless_texture_functions : require
// A mip of a volume from the one before: the sum of the eight texels that it covers, those at the end again where there
// are no more.

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(set = 0, binding = 0) uniform utexture3D finer;
layout(set = 0, binding = 1, r32ui) uniform writeonly uimage3D coarser;

void main() {
  const ivec3 place = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(place, imageSize(coarser)))) return;
  const ivec3 end = textureSize(finer, 0) - 1;
  uint sum = 0u;
  for (int i = 0; i < 8; ++i)
    sum += texelFetch(finer, min(2 * place + ivec3(i & 1, i >> 1 & 1, i >> 2), end), 0).x;
  imageStore(coarser, place, uvec4(sum));
}
