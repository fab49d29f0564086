#version 460
#extension GL_EXT_samplerless_texture_functions : require
// Each texel is the one of the frame before plus a number, and is copied into a buffer.

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform utexture2D before;
layout(set = 0, binding = 1, r32ui) uniform writeonly uimage2D after;
layout(set = 0, binding = 2) writeonly buffer Values {
  uint values[];
};

layout(push_constant) uniform Push {
  uint number;
};

void main() {
  const ivec2 place = ivec2(gl_GlobalInvocationID.xy), size = imageSize(after);
  if (any(greaterThanEqual(place, size))) return;
  const uint value = texelFetch(before, place, 0).x + number;
  imageStore(after, place, uvec4(value));
  values[place.x + size.x * place.y] = value;
}
