#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D sum;
layout(set = 0, binding = 1, rgba32f) writeonly uniform image2D mean;
layout(push_constant) uniform Push { float frame_weight; };

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(mean)))) return;
  imageStore(mean, pixel, texelFetch(sum, pixel, 0) * frame_weight);
}
