#version 460
#extension GL_GOOGLE_include_directive : require

#include "upload/caster.glsl"

void main() {
  gl_Position = caster_position();
}
