// Light from far away: maps of the sphere of directions, its prefiltered levels, and its irradiance.
#ifndef VEL_SHADING_ENVIRONMENT_GLSL
#define VEL_SHADING_ENVIRONMENT_GLSL

#include "shading/constants.glsl"
#include "shading/lang.glsl"
#include "shading/microfacet.glsl"
#include "shading/sampling.glsl"

// --- maps ---------------------------------------------------------------------------------------------------------

// Equirectangular picture, v from its top row: +y is up, +x in the middle, +z a quarter turn to its right.
// d: unit.
FN vec2 equirect_uv(vec3 d) {
  float polar = atan(sqrt(d.x * d.x + d.z * d.z), d.y);  // acos(d.y), without its loss of digits near the poles
  float z = d.z == 0.0f ? 0.0f : d.z;  // not -0, of which SwiftShader's atan makes 0 where d.x < 0, instead of -pi
  return vec2(0.5f + atan(z, d.x) / kTwoPi, polar / kPi);
}

// The inverse of equirect_uv.
FN vec3 equirect_direction(vec2 uv) {
  float azimuth = (uv.x - 0.5f) * kTwoPi;
  float polar = uv.y * kPi;
  return vec3(sin(polar) * cos(azimuth), cos(polar), sin(polar) * sin(azimuth));
}

struct CubeCoordinate {
  uint face;  // +x -x +y -y +z -z
  vec2 uv;    // 0..1, v from the top row
};

// Face and place in it that a cube map is read at along d, which is not null [Vulkan specification, "Cube Map Face
// Selection"].
FN CubeCoordinate cube_coordinate(vec3 d) {
  vec3 m = abs(d);
  CubeCoordinate c;
  vec2 st;
  float major;
  if (m.z >= m.x && m.z >= m.y) {
    c.face = d.z < 0.0f ? 5u : 4u;
    st = vec2(d.z < 0.0f ? -d.x : d.x, -d.y);
    major = m.z;
  } else if (m.y >= m.x) {
    c.face = d.y < 0.0f ? 3u : 2u;
    st = vec2(d.x, d.y < 0.0f ? -d.z : d.z);
    major = m.y;
  } else {
    c.face = d.x < 0.0f ? 1u : 0u;
    st = vec2(d.x < 0.0f ? d.z : -d.z, -d.y);
    major = m.x;
  }
  require(major > 0.0f);
  c.uv = 0.5f * st / major + vec2(0.5f);
  return c;
}

// The inverse of cube_coordinate; unit.
FN vec3 cube_direction(uint face, vec2 uv) {
  require(face < 6u);
  float s = 2.0f * uv.x - 1.0f;
  float t = 2.0f * uv.y - 1.0f;
  vec3 d = vec3(-s, -t, -1.0f);
  if (face == 0u) d = vec3(1.0f, -t, -s);
  if (face == 1u) d = vec3(-1.0f, -t, s);
  if (face == 2u) d = vec3(s, 1.0f, t);
  if (face == 3u) d = vec3(s, -1.0f, -t);
  if (face == 4u) d = vec3(s, -t, 1.0f);
  return normalize(d);
}

// World to the environment's own axes: the inverse of its turn about +Y, which takes +Z to +X. cosine, sine: of the turn.
FN vec3 turned_to_environment(vec3 d, float cosine, float sine) {
  return vec3(cosine * d.x - sine * d.z, d.y, sine * d.x + cosine * d.z);
}

// What occlusion leaves of the mirror direction [Lagarde & de Rousiers 2014, "Moving Frostbite to PBR", listing 26].
FN float specular_occlusion(float n_dot_v, float occlusion, float alpha) {
  return clamp(pow(n_dot_v + occlusion, exp2(-16.0f * alpha - 1.0f)) - 1.0f + occlusion, 0.0f, 1.0f);
}

// --- prefiltered specular levels ----------------------------------------------------------------------------------

// Levels of the prefiltered cube, linear in smoothness [Schulz 2014]: at 256 pixels a face the lobe of each level is
// about as wide as its texels.
const uint kPrefilterLevels = 7u;

FN float smoothness_of_level(float level) {
  return 1.0f - level / float(kPrefilterLevels - 1u);
}

FN float level_of_smoothness(float smoothness) {
  return float(kPrefilterLevels - 1u) * (1.0f - smoothness);
}

// --- irradiance ---------------------------------------------------------------------------------------------------

// Real spherical harmonics up to band 2 at the unit direction d [Ramamoorthi & Hanrahan 2001, eq. 3].
FN void sh_basis(vec3 d, OUT_ARRAY(float, basis, 9)) {
  basis[0] = 0.282094792f;
  basis[1] = 0.488602512f * d.y;
  basis[2] = 0.488602512f * d.z;
  basis[3] = 0.488602512f * d.x;
  basis[4] = 1.092548431f * d.x * d.y;
  basis[5] = 1.092548431f * d.y * d.z;
  basis[6] = 0.315391565f * (3.0f * d.z * d.z - 1.0f);
  basis[7] = 1.092548431f * d.x * d.z;
  basis[8] = 0.546274215f * (d.x * d.x - d.y * d.y);
}

// Irradiance / pi on a surface of unit normal n: the mean radiance that an albedo multiplies. coefficients: integrals
// of radiance times basis over solid angle. Bands are weighted 1, 2/3, 1/4, the clamped cosine / pi [ibid., eq. 8];
// what the missing bands would push below zero becomes 0.
FN vec3 sh_irradiance(IN_ARRAY(vec3, coefficients, 9), vec3 n) {
  float basis[9];
  sh_basis(n, basis);
  vec3 sum = coefficients[0] * basis[0];
  for (uint i = 1u; i < 4u; ++i) sum += coefficients[i] * (basis[i] * (2.0f / 3.0f));
  for (uint i = 4u; i < 9u; ++i) sum += coefficients[i] * (basis[i] * 0.25f);
  return max(sum, vec3(0.0f));
}

#endif
