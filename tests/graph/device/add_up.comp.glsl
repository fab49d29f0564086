#version 460
// Adds a number to each value of a buffer, and copies them into another.

layout(local_size_x = 64) in;

layout(set = 0, binding = 0) buffer Sums {
  uint sums[];
};
layout(set = 0, binding = 1) writeonly buffer Copies {
  uint copies[];
};

layout(push_constant) uniform Push {
  uint number;
};

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= sums.length()) return;
  sums[i] += number;
  copies[i] = sums[i];
}
