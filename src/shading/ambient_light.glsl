// Ambient lights: volumes in which light from all around is multiplied by a colour, diffuse and specular alike, so that
// the ratio of the two stays what the material makes it [Schulz 2014, The Rendering Technology of Ryse].
#ifndef VEL_SHADING_AMBIENT_LIGHT_GLSL
#define VEL_SHADING_AMBIENT_LIGHT_GLSL

#include "shading/lang.glsl"

struct GpuAmbientLight {
  // Rows of the matrix that takes metres from the light's centre to the space in which its volume is the unit sphere; w:
  // coordinates of the centre, world space, metres.
  vec4 x, y, z;
  vec4 color;  // rgb: what light is multiplied by at the centre, linear; a: unused
};
CHECK_LAYOUT(GpuAmbientLight, x, 0);
CHECK_LAYOUT(GpuAmbientLight, y, 16);
CHECK_LAYOUT(GpuAmbientLight, z, 32);
CHECK_LAYOUT(GpuAmbientLight, color, 48);

FN vec3 from_ambient_light(IN(GpuAmbientLight) l, vec3 position) {
  return position - vec3(l.x.w, l.y.w, l.z.w);
}

// (1 - D^2)^2: 1 at the centre, 0 with no slope at the end of the volume and beyond. D: the distance from the centre as a
// share of the volume's extent that way.
FN float ambient_attenuation(IN(GpuAmbientLight) l, vec3 position) {
  vec3 d = from_ambient_light(l, position);
  vec3 unit = vec3(dot(vec3(l.x.x, l.x.y, l.x.z), d), dot(vec3(l.y.x, l.y.y, l.y.z), d),
                   dot(vec3(l.z.x, l.z.y, l.z.z), d));
  float inside = clamp(1.0f - dot(unit, unit), 0.0f, 1.0f);
  return inside * inside;
}

// How much of an added light arrives: a surface that faces the centre gets all of it. occlusion: 1 where nothing is near.
// Crannies keep three tenths [Schulz 2014].
FN float ambient_facing(IN(GpuAmbientLight) l, vec3 position, vec3 normal, float occlusion) {
  vec3 d = from_ambient_light(l, position);
  float distance = length(d);
  // At the centre itself every direction is as good.
  float n_dot_l = distance > 0.0f ? clamp(-dot(normal, d) / distance, 0.0f, 1.0f) : 1.0f;
  return n_dot_l * (0.3f + 0.7f * occlusion);
}

// mix(1, color, k), as a form that is seen to be exactly 1 for a colour of 1, which changes no bit of a picture.
FN float ambient_channel(float color, float everywhere, float facing) {
  return 1.0f + (color - 1.0f) * (color > 1.0f ? facing : everywhere);
}

// What an ambient light multiplies the light from all around by. What brightens has a direction, what darkens has none: each
// channel by itself, so that a colour that passes 1 in one channel makes no jump. normal: unit, of the side that is lit.
FN vec3 ambient_light_factor(IN(GpuAmbientLight) l, vec3 position, vec3 normal, float occlusion) {
  require(l.color.x >= 0.0f && l.color.y >= 0.0f && l.color.z >= 0.0f);
  float everywhere = ambient_attenuation(l, position);
  float facing = everywhere * ambient_facing(l, position, normal, occlusion);
  return vec3(ambient_channel(l.color.x, everywhere, facing), ambient_channel(l.color.y, everywhere, facing),
              ambient_channel(l.color.z, everywhere, facing));
}

#endif
