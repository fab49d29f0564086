#version 460

// What a picture's geometric mean is shown as: the reflectance of middle grey [Reinhard et al. 2002, eqs. 1 and 2].
const float kKey = 0.18f;

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std430) readonly buffer Partials { vec2 partials[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Exposure { float exposure; };
layout(push_constant) uniform Push { float scale; };

void main() {
  vec2 sum = vec2(0.0f);
  for (int i = 0; i < partials.length(); ++i) sum += partials[i];
  // Nothing but black: there is no light to adapt to.
  exposure = sum.y > 0.0f ? scale * kKey / exp2(sum.x / sum.y) : scale;
}
