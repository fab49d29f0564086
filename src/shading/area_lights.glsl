// Light of a sphere of even radiance, or of the sun's disc, on glossy and matt surfaces without sampling it.
// `sine`: of the half angle under which the sphere is seen: its radius over the distance of its centre.
#ifndef VEL_SHADING_AREA_LIGHTS_GLSL
#define VEL_SHADING_AREA_LIGHTS_GLSL

#include "shading/brdf.glsl"
#include "shading/constants.glsl"
#include "shading/lang.glsl"

// Nearer than this the surface is as good as inside the sphere, where a cone of directions says little.
const float kMaxSphereSine = 0.99f;

// Where the light shines at the eye from behind the surface, the half vector turns faster than the small angles do that
// the formulas stand for.
const float kMinVDotH = 1e-3f;

// Half vectors nearer to the horizon than a thousandth are as far from the normal as matters.
const float kLeastCosine2 = 1e-6f;

// --- where in the sphere the highlight looks ----------------------------------------------------------------------
//
// [de Carpentier & Ishiyama 2017, Decima]: of all directions to the sphere, the one whose half vector is nearest to the
// normal gives the microfacet distribution, all else is taken at the centre. Unless the mirror direction hits the
// sphere, that direction lies on its rim, c L + s (cos phi T + sin phi B), where T points to the mirror direction.
// There
//   (n.h)^2 = (a.x + a.y cos + a.z sin)^2 / (2 (b.x + b.y cos + b.z sin)),   a: n.(v + l), b: 1 + v.l.

// As good as infinitely far, which is opposite on the rim; its square is finite.
const float kFarthestStep = 1e4f;

// `around`: cosine and sine of phi.
FN float rim_n_dot_h2(vec3 a, vec3 b, vec2 around) {
  float n = max(a.x + a.y * around.x + a.z * around.y, 0.0f);
  return n * n / (2.0f * (b.x + b.y * around.x + b.z * around.y));
}

// One step of Newton's method for the maximum of rim_n_dot_h2 in x = tan(phi / 2), from x = 0. Where the function is
// not concave there the step would lead to a minimum: it is left out. With g = ln f the step is -g' / (g'' + g'^2);
// times (PQ)^2 the terms without a.y, a.z, b.y, b.z cancel, which leaves no difference of nearly equal numbers.
FN vec2 rim_newton_step(vec3 a, vec3 b) {
  float p = a.x + a.y;
  float q = b.x + b.y;
  float slope = 4.0f * a.z * q - 2.0f * b.z * p;  // g' PQ
  float bend = 2.0f * (a.z * q - b.z * p);
  float curvature = 2.0f * bend * bend - 4.0f * p * q * (2.0f * a.y * q - b.y * p);  // (g'' + g'^2) (PQ)^2
  if (curvature >= 0.0f) return vec2(1.0f, 0.0f);
  float x = clamp(-slope * p * q / curvature, -kFarthestStep, kFarthestStep);
  float k = 1.0f / (1.0f + x * x);
  return vec2((1.0f - x * x) * k, 2.0f * x * k);
}

struct SphereHighlight {
  vec3 direction;  // unit, within the sphere
  float depth;     // how far inside the sphere the mirror direction lies: 0 at the rim and outside, 1 at the centre
};

// The direction to the sphere whose half vector with wo is nearest to n, as nearly as one step finds it. Where n turns
// away from the eye nothing is mirrored: the formula's direction lies below the surface and has the half vector -n.
// n, wo, wi: unit, wi to the centre. sine: 0 gives wi.
FN SphereHighlight sphere_highlight(vec3 n, vec3 wo, vec3 wi, float sine) {
  require(sine >= 0.0f && sine < 1.0f);
  SphereHighlight result;
  vec3 mirrored = 2.0f * dot(n, wo) * n - wo;
  float along = dot(mirrored, wi);
  vec3 off = mirrored - along * wi;
  float off2 = dot(off, off);
  if (dot(n, wo) > 0.0f && along > 0.0f && off2 < sine * sine) {
    result.direction = mirrored;
    result.depth = 1.0f - sqrt(off2) / sine;
    return result;
  }

  float cosine = sqrt(1.0f - sine * sine);
  vec3 t = off * inversesqrt(max(off2, 1e-12f));
  vec3 bitangent = cross(t, wi);
  vec3 a = vec3(dot(n, wo) + cosine * dot(n, wi), sine * dot(n, t), sine * dot(n, bitangent));
  vec3 b = vec3(1.0f + cosine * dot(wo, wi), sine * dot(wo, t), sine * dot(wo, bitangent));
  vec2 nearest = vec2(1.0f, 0.0f);  // the rim's point next to the mirror direction [Karis 2013]
  vec2 around = rim_newton_step(a, b);
  if (rim_n_dot_h2(a, b, around) < rim_n_dot_h2(a, b, nearest)) around = nearest;
  result.direction = cosine * wi + sine * (around.x * t + around.y * bitangent);
  result.depth = 0.0f;
  return result;
}

// --- how bright -----------------------------------------------------------------------------------------------------
//
// In the plane of half vectors, in units of alpha, the sphere is an ellipse of semi-axes a = s / (2 alpha) and
// a / v.h, which the GGX lobe 1 / (1 + t^2)^2 is averaged over. A lobe bent to the ellipse's nearest point says how
// far the ellipse is; how bright it is, a disc of the same area at the same distance says.

// The mean of 1 / (1 + t^2)^2 over a disc of radius `radius` whose edge passes the origin at `edge`, negative where it
// holds the origin. Exact: over the plane this lobe is pi times the density of the unit sphere's area under
// stereographic projection, which takes discs to caps.
FN float ggx_disc_mean(float edge, float radius) {
  require(edge >= -radius && radius >= 0.0f);
  float far_edge = edge + 2.0f * radius;
  float root = sqrt((1.0f + edge * edge) * (1.0f + far_edge * far_edge));
  float middle = 1.0f + edge * far_edge;
  // Two forms of the same, each without a difference of nearly equal numbers.
  if (middle > 0.0f) return 2.0f / (root * (root + middle));
  return 0.5f * (1.0f - middle / root) / (radius * radius);
}

// Energy of the lobe bent by a convex shape in that plane, over that of the lobe: Steiner's formula with the integral
// of the lobe along a line from its peak, 1/4, and its peak, 1/pi.
FN float bent_lobe_energy(float perimeter, float area) {
  return 1.0f + 0.25f * perimeter + kInvPi * area;
}

// Tangent of the angle between unit vectors n and h, where that is less than 90 degrees; else very large.
FN float slope_between(vec3 n, vec3 h) {
  float sin2 = sin2_of_half_vector(n, h);
  return sqrt(sin2 / max(1.0f - sin2, kLeastCosine2));
}

// v.h of the directions that shine most: about the sphere's centre where the lobe is wider than the sphere, about the
// highlight where the sphere is, between them by their areas in the plane of half vectors.
FN float sphere_v_dot_h(IN(SphereHighlight) highlight, vec3 wo, vec3 wi, float sine, float alpha) {
  float width = 0.5f * sine / alpha, width2 = width * width;
  vec3 shining = normalize(mix(wi, highlight.direction, width2 / (1.0f + width2)));
  // Of unit vectors v.h is half the length of their sum, which has digits where they are opposite and h has none.
  return max(0.5f * length(wo + shining), kMinVDotH);
}

// What the bent lobe is multiplied by. edge, center: tangents between the normal and the half vectors of the bent
// direction and of the sphere's centre.
FN float sphere_highlight_scale(IN(SphereHighlight) highlight, float edge, float center, float sine, float alpha,
                                float v_dot_h) {
  require(alpha > 0.0f && v_dot_h > 0.0f);
  float short_axis = 0.5f * sine / alpha;
  float radius = short_axis * inversesqrt(v_dot_h);
  float near = edge / alpha;
  // Next to the ellipse its edge counts, far from it its centre: the disc moves from one to the other.
  float reach = clamp(center / alpha - near, short_axis, short_axis / v_dot_h);  // of the ellipse towards the normal
  float moved = reach - radius;
  float disc_edge =
      highlight.depth > 0.0f ? -radius * highlight.depth : near + moved * near / max(near + radius, 1e-6f);
  float peak = 1.0f + near * near;
  float mean = ggx_disc_mean(disc_edge, radius) * peak * peak;
  // The ellipse's perimeter, nearly pi times the sum of its semi-axes, collects more light than the disc's.
  float area = kPi * radius * radius;
  float ellipse = bent_lobe_energy(kPi * short_axis * (1.0f + 1.0f / v_dot_h), area);
  return mean * bent_lobe_energy(kTwoPi * radius, area) / ellipse;
}

// --- what the horizon leaves --------------------------------------------------------------------------------------

// z - atan(z) without the loss of digits of small z, which drivers' atan would take even more of. z >= 0.
FN float excess_over_atan(float z) {
  if (z > 0.5f) return z - atan(z);
  float z2 = z * z;
  return z * z2 * (1.0f / 3.0f - z2 * (1.0f / 5.0f - z2 * (1.0f / 7.0f - z2 * (1.0f / 9.0f))));
}

// The irradiance of the sphere as a share of that on a plane which faces it: n.l as long as the whole sphere is above
// the horizon, 0 once it has set, between them the form factor of what is left of it [Snyder 1996], whose difference
// of large terms is taken by hand. n_dot_l: to its centre.
FN float sphere_horizon_cosine(float n_dot_l, float sine) {
  require(sine < 1.0f);
  if (n_dot_l >= sine) return n_dot_l;
  if (n_dot_l <= -sine) return 0.0f;
  float cosine = sqrt(1.0f - sine * sine);
  float up = n_dot_l / sine;
  float half_chord = sqrt(max(1.0f - up * up, 0.0f));
  float turn = acos(clamp(-cosine * up * inversesqrt(1.0f - n_dot_l * n_dot_l), -1.0f, 1.0f));
  float below = excess_over_atan(half_chord * sine / cosine) / (sine * sine);
  return max(kInvPi * (n_dot_l * turn + half_chord * sine / cosine - below), 0.0f);
}

// evaluate_brdf() for a sphere: the light's irradiance on a plane that faces it times this is what goes towards wo.
// wi: to its centre. alpha: of the surface. specular_scale: energy_compensation(), or 1.
FN vec3 evaluate_brdf_sphere(IN(Surface) s, float alpha, vec3 wo, vec3 wi, float sine, vec3 specular_scale,
                             uint model) {
  float seen_sine = min(sine, kMaxSphereSine);
  float n_dot_l = sphere_horizon_cosine(dot(s.normal_ws, wi), seen_sine);
  SphereHighlight highlight = sphere_highlight(s.normal_ws, wo, wi, seen_sine);
  vec3 bent_half = half_vector(wo, highlight.direction);
  float edge = slope_between(s.normal_ws, bent_half);
  float center = slope_between(s.normal_ws, half_vector(wo, wi));
  float v_dot_h = sphere_v_dot_h(highlight, wo, wi, seen_sine, alpha);
  vec3 scale = specular_scale * sphere_highlight_scale(highlight, edge, center, seen_sine, alpha, v_dot_h);
  return evaluate_brdf_bent(s, alpha, wo, wi, n_dot_l, bent_half, v_dot_h, scale, model);
}

#endif
