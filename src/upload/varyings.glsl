// What the vertex shader of shaded geometry hands on to fragment shaders. The includer says what VARYING is, in or out.
#ifndef VEL_UPLOAD_VARYINGS_GLSL
#define VEL_UPLOAD_VARYINGS_GLSL

layout(location = 0) VARYING vec3 varying_normal_ws;   // null where the geometry has none
layout(location = 1) VARYING vec4 varying_tangent_ws;  // w: sign of the bitangent
layout(location = 2) VARYING vec4 varying_uv;          // two sets
layout(location = 3) VARYING vec4 varying_color;
layout(location = 4) VARYING vec3 varying_position_ws;

#endif
