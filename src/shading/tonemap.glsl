// From scene radiance, scaled by exposure, to display light in [0, 1]; linear BT.709 on both sides.
#ifndef VEL_SHADING_TONEMAP_GLSL
#define VEL_SHADING_TONEMAP_GLSL

#include "shading/color.glsl"
#include "shading/lang.glsl"

// The order of velarium::Tonemap.
const uint kTonemapNeutral = 0u;
const uint kTonemapAgx = 1u;
const uint kTonemapAces = 2u;
const uint kTonemapLinear = 3u;

// What radiance is multiplied by at exposure value `ev100` [ISO 12232 saturation; Lagarde & de Rousiers 2014, 4.2.4].
FN float exposure_from_ev100(float ev100) {
  return 1.0f / (1.2f * exp2(ev100));
}

// Khronos PBR Neutral [Khronos 2024]: base colours pass unchanged up to 0.76, highlights roll off and lose saturation.
FN vec3 tonemap_neutral(vec3 color) {
  const float start = 0.8f - 0.04f;  // of the roll-off; 0.04 is the Fresnel reflection that is taken off first
  const float desaturation = 0.15f;
  vec3 c = max(color, vec3(0.0f));
  float low = min_component(c);
  c -= vec3(low < 0.08f ? low - 6.25f * low * low : 0.04f);
  float peak = max_component(c);
  if (peak < start) return c;
  float room = 1.0f - start;
  float new_peak = 1.0f - room * room / (peak + room - start);
  float grey = 1.0f - 1.0f / (desaturation * (peak - new_peak) + 1.0f);
  return mix(c * (new_peak / peak), vec3(new_peak), grey);
}

// The sigmoid of AgX as a polynomial of the log encoding, 0..1 -> display code values [Wrensch 2023].
FN vec3 agx_contrast(vec3 x) {
  vec3 x2 = x * x;
  vec3 x4 = x2 * x2;
  vec3 high = 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4;
  return high - 6.868f * x2 * x + 0.4298f * x2 + 0.1191f * x - vec3(0.00232f);
}

// AgX [Sobotka 2022] in the fit of Wrensch (2023): inset, log2 from -12.47 to +4.03 stops, sigmoid, outset, 2.2 decode.
FN vec3 tonemap_agx(vec3 color) {
  const mat3 inset = mat3(0.842479062f, 0.0423282423f, 0.0423756549f,  //
                          0.0784336f, 0.878468636f, 0.0784336f,        //
                          0.0792237452f, 0.0791661275f, 0.879142974f);

  const mat3 outset = mat3(1.19687901f, -0.0528968518f, -0.0529716355f,  //
                           -0.0980208811f, 1.15190313f, -0.0980434501f,  //
                           -0.0990297441f, -0.0989611768f, 1.15107367f);

  const float min_ev = -12.47393f;
  const float max_ev = 4.026069f;
  vec3 stops = log2(max(inset * max(color, vec3(0.0f)), vec3(1e-10f)));
  vec3 encoded = agx_contrast(clamp((stops - vec3(min_ev)) / (max_ev - min_ev), 0.0f, 1.0f));
  return pow(clamp(outset * encoded, 0.0f, 1.0f), vec3(2.2f));
}

// ACES 1.0 reference rendering and sRGB output transforms in the fit of Hill (2016): two matrices around a rational
// curve. Divided by 0.6 first, so that 0.18 comes out about as bright as with the other curves.
FN vec3 tonemap_aces(vec3 color) {
  const mat3 inset = mat3(0.59719f, 0.07600f, 0.02840f,  //
                          0.35458f, 0.90834f, 0.13383f,  //
                          0.04823f, 0.01566f, 0.83777f);
  const mat3 outset = mat3(1.60475f, -0.10208f, -0.00327f,  //
                           -0.53108f, 1.10813f, -0.07276f,  //
                           -0.07367f, -0.00605f, 1.07602f);
  vec3 v = inset * (max(color, vec3(0.0f)) / 0.6f);
  vec3 a = v * (v + vec3(0.0245786f)) - vec3(0.000090537f);
  vec3 b = v * (0.983729f * v + vec3(0.4329510f)) + vec3(0.238081f);
  return clamp(outset * (a / b), 0.0f, 1.0f);
}

// No curve: what exceeds the display is cut off.
FN vec3 tonemap_linear(vec3 color) {
  return clamp(color, 0.0f, 1.0f);
}

FN vec3 tonemap(uint curve, vec3 color) {
  if (curve == kTonemapNeutral) return tonemap_neutral(color);
  if (curve == kTonemapAgx) return tonemap_agx(color);
  if (curve == kTonemapAces) return tonemap_aces(color);
  return tonemap_linear(color);
}

#endif
