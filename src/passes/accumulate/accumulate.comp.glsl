#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "passes/accumulate/accumulate_io.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(sum)))) return;
  vec4 value = texelFetch(hdr, pixel, 0);
  if (!kFirst) value += imageLoad(sum, pixel);
  imageStore(sum, pixel, value);
}
