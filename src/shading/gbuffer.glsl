// Three RGBA8 targets [Schulz 2014, Ryse]; beside them depth, and the material class in the stencil:
//
//   normal    UNORM  rgb  best-fit normal                a  occlusion, or Y of transmittance (kClassTransmittance)
//   albedo    SRGB   rgb  diffuse albedo                 a  0
//   specular  UNORM  r    smoothness   g  Y of f0        ba Cb, Cr of f0, or of transmittance (kClassTransmittance)
//
// Luma apart from chroma, and chroma split over blue and alpha, let a decal blend rgb while alpha is its weight.
#ifndef VEL_SHADING_GBUFFER_GLSL
#define VEL_SHADING_GBUFFER_GLSL

#include "shading/lang.glsl"
#include "shading/normal_encoding.glsl"
#include "shading/specular_encoding.glsl"
#include "shading/surface.glsl"

// Values before the target's conversion to codes, and after its conversion back. albedo is linear: its format is sRGB.
struct GBufferTexel {
  vec4 normal, albedo, specular;
};

// bfn_table_value: the best-fit length read at bfn_table_texel(s.normal_ws).
FN GBufferTexel gbuffer_encode(IN(Surface) s, float bfn_table_value) {
  vec3 normal = bfn_encode(s.normal_ws, bfn_table_value);
  vec3 specular = specular_encode(s.f0);
  bool transmits = s.material_class == kClassTransmittance;
  vec2 chroma =
      transmits ? clamp(s.transmittance_chroma + vec2(kChromaBias), 0.0f, 1.0f) : vec2(specular.y, specular.z);
  GBufferTexel t;
  t.normal = vec4(normal, transmits ? s.transmittance_luma : s.occlusion);
  t.albedo = vec4(s.albedo, 0.0f);
  t.specular = vec4(s.smoothness, specular.x, chroma.x, chroma.y);
  return t;
}

// Normals are stored at lengths whose components lie close to integers. To move them by a whole code would undo that:
// each frame would err by 0.060 degrees instead of 0.038. By half of one, components nearer than a quarter to an integer
// stay, as those of axes do, and frames are as good as they were; what lies halfway falls to either side in turn. That
// is what normal maps call flat, (1, 1, 255) / 255, and what leans by less than half a degree: its mean errs half as much.
const float kNormalRounding = 0.5f;

// Moves what is about to be rounded by `shift` codes, rounding_shift(). The albedo moves along a square root, whose slope is
// within an eighth of the sRGB curve's from 0.05 to 1.
FN GBufferTexel gbuffer_shifted(IN(GBufferTexel) t, float shift) {
  float step = shift / 255.0f;
  float normal_step = kNormalRounding * step;
  vec3 root = max(sqrt(vec3(t.albedo.x, t.albedo.y, t.albedo.z)) + vec3(step), vec3(0.0f));
  GBufferTexel moved;
  moved.normal = t.normal + vec4(normal_step, normal_step, normal_step, step);
  moved.albedo = vec4(root * root, t.albedo.w);
  moved.specular = t.specular + vec4(step);
  return moved;
}

// A transmitting surface comes back with grey f0 and occlusion 1, every other one with transmittance 0.
FN Surface gbuffer_decode(IN(GBufferTexel) t, uint material_class) {
  bool transmits = material_class == kClassTransmittance;
  vec2 chroma = vec2(t.specular.z, t.specular.w);
  vec2 specular_chroma = transmits ? vec2(kChromaBias) : chroma;
  Surface s;
  s.normal_ws = bfn_decode(vec3(t.normal.x, t.normal.y, t.normal.z));
  s.albedo = vec3(t.albedo.x, t.albedo.y, t.albedo.z);
  s.f0 = specular_decode(vec3(t.specular.y, specular_chroma.x, specular_chroma.y));
  s.smoothness = t.specular.x;
  s.occlusion = transmits ? 1.0f : t.normal.w;
  s.transmittance_luma = transmits ? t.normal.w : 0.0f;
  s.transmittance_chroma = transmits ? chroma - vec2(kChromaBias) : vec2(0.0f);
  s.material_class = material_class;
  return s;
}

#endif
