// The view that a frame is drawn from, and where its pixels lie. GLSL only.
#ifndef VEL_UPLOAD_FRAME_GLSL
#define VEL_UPLOAD_FRAME_GLSL

#include "upload/frame_io.glsl"

// Of directions. Transposed, it goes from the view to the world.
mat3 view_rotation() {
  return mat3(frame.view_from_world);
}

// The pixel that a place is seen in.
uvec2 pixel_of(vec3 position_ws) {
  vec4 clip = frame.clip_from_world * vec4(position_ws, 1.0);
  return uvec2(clamp(clip.xy / clip.w * 0.5 + 0.5, 0.0, 1.0) * frame.size.xy);
}

#endif
