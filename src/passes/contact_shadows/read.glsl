// Contact shadows, on the device: the march of shading/contact_shadow.glsl. GLSL only.
#ifndef VEL_PASSES_CONTACT_SHADOWS_READ_GLSL
#define VEL_PASSES_CONTACT_SHADOWS_READ_GLSL

#include "passes/contact_shadows/contact_shadows_io.glsl"
#include "passes/gbuffer/read_depth_buffer.glsl"
#include "shading/contact_shadow.glsl"
#include "shading/sampling.glsl"

// What of a march does not depend on the light.
struct ContactReceiver {
  vec3 start_ws;
  float view_depth;
  float footprint_m;  // of a pixel
  vec2 slope;         // of device depth along x and y, a pixel
  float jitter;       // in [0, 1)
};

// The place in the picture, pixels.
vec2 clip_pixel(vec4 clip) {
  return (clip.xy / clip.w * 0.5 + 0.5) * frame.size.xy;
}

ContactReceiver contact_receiver_at(ivec2 pixel, float view_depth, vec3 position_ws, vec3 normal_ws) {
  ContactReceiver r;
  float at = device_depth_at(pixel);
  r.slope.x = depth_slope(device_depth_at(pixel - ivec2(1, 0)), at, device_depth_at(pixel + ivec2(1, 0)));
  r.slope.y = depth_slope(device_depth_at(pixel - ivec2(0, 1)), at, device_depth_at(pixel + ivec2(0, 1)));
  r.footprint_m = pixel_footprint(view_depth, frame.ndc_to_view, frame.perspective, frame.size.y);
  r.start_ws = position_ws + normal_ws * (kContactLift * r.footprint_m);
  r.view_depth = view_depth;
  r.jitter = screen_noise(uvec2(pixel), frame.frame_index, frame.seed);
  return r;
}

// Where a ray towards a light is looked for in the picture.
struct ContactRay {
  vec4 from, way;         // of clip space
  vec2 depth;             // view depth at its start, and how that changes along it, metres
  vec2 own;               // the centre of the receiver's pixel
  float thickness_m;
  uint steps;
};

ContactRay contact_ray(ContactReceiver r, vec3 wi, float length_m, float thickness_m) {
  vec3 way_ws = wi * length_m;
  ContactRay ray;
  ray.from = frame.clip_from_world * vec4(r.start_ws, 1.0);
  ray.way = frame.clip_from_world * vec4(way_ws, 0.0);
  ray.depth.x = -(frame.view_from_world * vec4(r.start_ws, 1.0)).z;
  ray.depth.y = -(frame.view_from_world * vec4(way_ws, 0.0)).z;
  vec2 pixel_from = clip_pixel(ray.from), pixel_to = clip_pixel(ray.from + ray.way);
  vec2 passed = abs(pixel_to - pixel_from);
  ray.steps = contact_steps(max(passed.x, passed.y), kContactSteps);
  ray.own = floor(pixel_from) + 0.5;
  ray.thickness_m = thickness_m;
  return ray;
}

// Is the ray blocked where it is seen at `place`, in pixels, so far along it? Where that lies beside the centre of its
// pixel, the depth there is taken to the place by the slope of the receiver: on a plane that is exact, so that no plane
// shadows itself. The receiver's own pixel shows the receiver: at an edge, where the slope may be another face's, it must
// not shadow itself either.
bool contact_hit(ContactReceiver r, ContactRay ray, vec2 place, float along) {
  vec2 center = floor(place) + 0.5;
  float surface = device_depth_at(ivec2(place));
  float surface_m = view_depth(surface + dot(r.slope, place - center), frame.depth_params);
  bool elsewhere = any(greaterThan(abs(center - ray.own), vec2(0.5)));
  return elsewhere && surface > 0.0 && contact_blocked(ray.depth.x + along * ray.depth.y, surface_m, ray.thickness_m);
}

// What near surfaces leave of the light from direction `wi`, which comes from `distance` metres away and whose map has
// texels of `texel_m` metres at the receiver; kUnboundedRadius where it has none.
//
// Points of the ray are linear in view space, so that its depth is too; its place in the picture is the quotient of what
// is linear in clip space. The loop has one way out, at its end: drivers that run pixels in lockstep lose track of others.
float contact_visibility(ContactReceiver r, vec3 wi, float distance, float texel_m) {
  if (kContactSteps == 0u || texel_m == 0.0) return 1.0;
  float height_m = frame.size.y * r.footprint_m;  // of the picture
  float length_m = min(contact.longest * height_m, min(distance, kContactTexels * texel_m));
  ContactRay ray = contact_ray(r, wi, length_m, min(contact.thickness * height_m, texel_m));
  float visible = 1.0;
  uint i = 0u;
  do {
    float along = (float(i) + 1.0 - r.jitter) / float(ray.steps);
    vec2 place = clip_pixel(ray.from + along * ray.way);
    bool inside = all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, frame.size.xy));
    bool hit = inside && contact_hit(r, ray, place, along);
    if (hit) visible = 1.0 - contact_darkness(along) * contact_border(place, frame.size.xy);
    i = inside && !hit ? i + 1u : ray.steps;
  } while (i < ray.steps);
  return visible;
}

#endif
