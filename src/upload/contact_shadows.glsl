// Contact shadows, on the device: the march of shading/contact_shadow.glsl. GLSL only.
// The includer defines, before: FrameUniforms frame; sampler2D depth_map, the depth of the whole picture.
#ifndef VEL_UPLOAD_CONTACT_SHADOWS_GLSL
#define VEL_UPLOAD_CONTACT_SHADOWS_GLSL

#include "shading/contact_shadow.glsl"
#include "shading/sampling.glsl"
#include "upload/gpu_structs.glsl"

layout(constant_id = 10) const uint kContactShadows = 0u;      // most samples a ray takes; 0: there are none
layout(constant_id = 18) const float kContactLength = 0.0;     // of a ray, as a share of the picture's height
layout(constant_id = 19) const float kContactThickness = 0.0;  // of what blocks it, the same

// What of a march does not depend on the light.
struct ContactReceiver {
  vec3 start_ws;
  float view_depth;
  float footprint_m;  // of a pixel
  vec2 slope;         // of device depth along x and y, a pixel
  float jitter;       // in [0, 1)
};

// Device depth, or 0 outside the picture, as where nothing was drawn.
float contact_depth(ivec2 pixel) {
  bool outside = any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(frame.size.xy)));
  return outside ? 0.0 : texelFetch(depth_map, pixel, 0).r;
}

ContactReceiver contact_receiver_at(ivec2 pixel, float view_depth, vec3 position_ws, vec3 normal_ws) {
  ContactReceiver r;
  float at = contact_depth(pixel);
  r.slope.x = depth_slope(contact_depth(pixel - ivec2(1, 0)), at, contact_depth(pixel + ivec2(1, 0)));
  r.slope.y = depth_slope(contact_depth(pixel - ivec2(0, 1)), at, contact_depth(pixel + ivec2(0, 1)));
  r.footprint_m = pixel_footprint(view_depth, frame.ndc_to_view, frame.perspective, frame.size.y);
  r.start_ws = position_ws + normal_ws * (kContactLift * r.footprint_m);
  r.view_depth = view_depth;
  r.jitter = screen_noise(uvec2(pixel), frame.frame_index, frame.seed);
  return r;
}

// What near surfaces leave of the light from direction `wi`, which comes from `distance` metres away.
//
// Points of the ray are linear in view space, so that its depth is too; its place in the picture is the quotient of what
// is linear in clip space. Where a sample lies beside the centre of its pixel, the depth there is taken to the sample's
// place by the slope of the receiver: on a plane that is exact, so that no plane shadows itself.
float contact_visibility(ContactReceiver r, vec3 wi, float distance) {
  if (kContactShadows == 0u) return 1.0;
  float length_m = min(kContactLength * frame.size.y * r.footprint_m, distance);
  float thickness_m = kContactThickness * frame.size.y * r.footprint_m;
  vec3 way = wi * length_m;
  vec4 from = frame.clip_from_world * vec4(r.start_ws, 1.0);
  vec4 to = from + frame.clip_from_world * vec4(way, 0.0);
  float depth_from = -(frame.view_from_world * vec4(r.start_ws, 1.0)).z;
  float depth_change = -(frame.view_from_world * vec4(way, 0.0)).z;
  vec2 pixel_from = (from.xy / from.w * 0.5 + 0.5) * frame.size.xy;
  vec2 pixel_to = (to.xy / to.w * 0.5 + 0.5) * frame.size.xy;
  vec2 passed = abs(pixel_to - pixel_from);
  uint steps = contact_steps(max(passed.x, passed.y), kContactShadows);

  uint i = 0u;
  do {
    float along = (float(i) + 1.0 - r.jitter) / float(steps);
    vec4 clip = mix(from, to, along);
    vec2 place = (clip.xy / clip.w * 0.5 + 0.5) * frame.size.xy;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(place, frame.size.xy))) return 1.0;
    vec2 center = floor(place) + 0.5;
    float surface = texelFetch(depth_map, ivec2(place), 0).r;
    float ray_m = depth_from + along * depth_change;
    float surface_m = view_depth(surface + dot(r.slope, place - center), frame.depth_params);
    if (surface > 0.0 && contact_blocked(ray_m, surface_m, thickness_m))
      return 1.0 - contact_darkness(along) * contact_border(place, frame.size.xy);
  } while (++i < steps);
  return 1.0;
}

#endif
