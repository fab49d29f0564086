#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "running_difference_io.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(sum)))) return;
  vec4 now = imageLoad(sum, pixel);
  imageStore(after, pixel, now);
  imageStore(sum, pixel, now - texelFetch(before, pixel, 0));
}
