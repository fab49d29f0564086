#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool kFirst = false;
layout(set = 0, binding = 0) uniform sampler2D hdr;
layout(set = 0, binding = 1, rgba32f) uniform image2D sum;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(sum)))) return;
  vec4 value = texelFetch(hdr, pixel, 0);
  if (!kFirst) value += imageLoad(sum, pixel);
  imageStore(sum, pixel, value);
}
