#include "reference/path.hpp"

#include "reference/brdf_sampling.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::reference {
namespace {

using shading::uvec2, shading::vec2, shading::vec3;

// Before so many reflections no path is ended by chance: it would only add noise where most of the light is.
constexpr std::uint32_t kSafeReflections = 3;
constexpr float kMostSurvive = 0.95f;

// Of the angle that a reflected ray stands for, one over the root of its density, so much may blur the textures it
// meets. The widest is a diffuse one: 0.18 rad.
constexpr float kConeShare = 0.1f;

// How far from a surface its rays start, in units of what rounding may have moved it.
constexpr float kRayClearance = 2.0f;

// Weight of one of two ways to find the same light [Veach 1997, power heuristic].
float balance(float pdf, float other_pdf) {
  const float ratio = other_pdf / pdf;
  return 1.0f / (1.0f + ratio * ratio);
}

// A normal near `n` by whose mirror image of wo nothing is lost below the triangle: normals that are interpolated or
// mapped may turn so far that the whole lobe points into the surface, which then would be black. `outside`: the side of
// the triangle that wo is on. Where n mirrors wo too low it is bent towards `outside`, no farther than it must be.
vec3 bent_normal(const vec3& n, const vec3& outside, const vec3& wo) {
  constexpr float kLeastRise = 0.01f;  // sine of the mirrored direction over the triangle, where wo itself is higher
  constexpr int kHalvings = 12;        // to 2^-12 of the way, under a step of an 8-bit normal map
  const auto rise = [&](const vec3& h) {
    return 2.0f * glm::dot(h, wo) * glm::dot(h, outside) - glm::dot(wo, outside);
  };
  const float least = std::min(kLeastRise, 0.9f * glm::dot(wo, outside));
  if (rise(n) >= least) return n;
  if (glm::dot(n, outside) < -0.99f) return outside;  // opposite ones have no mean
  float low = 0.0f, high = 1.0f;                      // shares of `outside`, by which wo is mirrored as high as it is
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5f * (low + high);
    (rise(glm::normalize(glm::mix(n, outside, middle))) < least ? low : high) = middle;
  }
  return glm::normalize(glm::mix(n, outside, high));
}

std::uint32_t hash_of(uvec2 pixel, std::uint32_t sample, std::uint32_t seed) {
  using shading::hash_u32;
  return hash_u32(pixel.x ^ hash_u32(pixel.y ^ hash_u32(sample ^ hash_u32(seed))));
}

}  // namespace

// The random numbers of one vertex, drawn whether they are used or not: see Sequence.
struct PathTracer::Draws {
  explicit Draws(Sequence& s)
      : light(s.next_1d()),
        light_place(s.next_2d()),
        lobe(s.next_1d()),
        direction(s.next_2d()),
        survival(s.next_1d()) {}
  float light;
  vec2 light_place;
  float lobe;
  vec2 direction;
  float survival;
};

struct PathTracer::Path {
  Path(uvec2 pixel, std::uint32_t sample, std::uint32_t seed)
      : sequence(pixel, sample, seed), chance(hash_of(pixel, sample, ~seed)) {}

  // Light that the throughput brings to the eye, after so many reflections.
  void add(const vec3& light, std::uint32_t reflected, float clamp) {
    vec3 brought = throughput * light;
    if (reflected < 2) {
      found.direct += brought;
      return;
    }
    const float largest = shading::max_component(brought);
    if (clamp > 0.0f && largest > clamp) brought *= clamp / largest;
    found.indirect += brought;
  }
  [[nodiscard]] std::uint32_t next_chance() { return chance = shading::hash_u32(chance); }

  Sequence sequence;
  std::uint32_t chance;  // of all that needs no well spread numbers: transparency, mips
  Ray ray;
  vec3 throughput{1.0f};
  std::uint32_t reflections = 0;
  // Of the reflection that the ray comes from: what lights could have been aimed at from there, and how likely it was.
  Receiver receiver;
  LightChances chances;
  float pdf_sr = 0.0f;
  PathSample found;
};

struct PathTracer::Vertex {
  SurfacePoint point;
  bool front = true;
  vec3 outside{0.0f};  // the geometric normal, on the side that was hit
  vec3 wo{0.0f};
  Look look;
  float alpha = 1.0f;
  vec3 specular_scale{1.0f};
  float cone_width_m = 0.0f;

  [[nodiscard]] vec3 start() const { return point.position_ws + kRayClearance * point.rounding_m * outside; }
};

PathSample PathTracer::trace(uvec2 pixel, std::uint32_t sample) const {
  Path path(pixel, sample, seed_);
  path.ray = world_.camera.ray(vec2(pixel) + path.sequence.next_2d());
  path.ray.cone_width_m /= transport_.sharpness;
  path.ray.cone_spread /= transport_.sharpness;
  follow(path);
  return path.found;
}

void PathTracer::follow(Path& path) const {
  while (true) {
    path.ray.chance = path.next_chance();
    const auto [hit, transparent] = world_.geometry.closest(path.ray);
    const float reach = hit ? hit->distance : std::numeric_limits<float>::infinity();
    if (transport_.shadows) add_spheres(path, transparent, reach);
    // What is seen is mixed by coverage, as the picture's alpha has it; light that arrives is dyed as well.
    if (path.reflections > 0) path.throughput *= transparent.tint_before(reach);
    if (!hit) {
      if (path.reflections == 0) return add_background(path);
      if (transport_.shadows) add_environment(path);
      return;
    }
    const Vertex vertex = vertex_at(path, *hit);
    if (path.reflections == 0) {
      path.found.hit = true;
      path.found.alpha = 1.0f;
      path.found.albedo = vertex.look.unlit ? vertex.look.emission : vertex.look.surface.albedo;
      path.found.normal_ws = vertex.look.surface.normal_ws;
      path.found.depth = world_.camera.view_depth(vertex.point.position_ws);
    }
    add_emission(path, *hit, vertex);
    if (vertex.look.unlit || path.reflections == transport_.reflections) return;
    const Draws draws(path.sequence);
    path.receiver = {vertex.point.position_ws, vertex.look.surface.normal_ws};
    path.chances = world_.lights.chances(
        path.receiver, {.environment = transport_.environment, .emitters = transport_.emissive_lighting});
    add_light(path, vertex, draws);
    if (!reflect(path, vertex, draws)) return;
  }
}

PathTracer::Vertex PathTracer::vertex_at(const Path& path, const Hit& hit) const {
  Vertex v;
  v.point = surface_point(world_.objects[hit.object], hit.triangle, hit.u, hit.v);
  v.wo = -path.ray.direction;
  v.front = glm::dot(v.wo, v.point.geometric_normal_ws) >= 0.0f;
  v.outside = v.front ? v.point.geometric_normal_ws : -v.point.geometric_normal_ws;
  v.cone_width_m = path.ray.cone_at(hit.distance);
  v.look = world_.materials.look(v.point, v.front, {v.cone_width_m, shading::hash_to_float(path.chance)});
  shading::Surface& s = v.look.surface;
  if (transport_.shadows) s.normal_ws = bent_normal(s.normal_ws, v.outside, v.wo);
  v.alpha = shading::alpha_from_smoothness(s.smoothness);
  if (transport_.multi_scatter) {
    const float n_dot_v = std::min(std::abs(glm::dot(s.normal_ws, v.wo)), 1.0f);
    v.specular_scale = shading::energy_compensation(s.f0, world_.energy.read(n_dot_v, s.smoothness));
  }
  return v;
}

void PathTracer::add_background(Path& path) const {
  if (transport_.background) path.found.direct = world_.lights.environment(path.ray.direction);
  path.found.alpha = transport_.opaque_background ? 1.0f : 0.0f;
}

void PathTracer::add_environment(Path& path) const {
  if (!(path.chances.environment > 0.0f)) return;
  const float other = world_.lights.pdf_sr_environment(path.chances, path.ray.direction);
  path.add(balance(path.pdf_sr, other) * world_.lights.environment(path.ray.direction), path.reflections,
           transport_.clamp);
}

void PathTracer::add_spheres(Path& path, const TransparentHits& transparent, float distance) const {
  if (path.reflections == 0 || !world_.lights.has_spheres()) return;
  world_.lights.for_each_sphere(
      path.receiver, path.chances, path.ray.direction, distance, [&](const Lights::SphereHit& hit) {
        path.add(balance(path.pdf_sr, hit.pdf_sr) * hit.radiance * transparent.tint_before(hit.distance),
                 path.reflections, transport_.clamp);
      });
}

void PathTracer::add_emission(Path& path, const Hit& hit, const Vertex& vertex) const {
  const vec3& emission = vertex.look.emission;
  if (emission == vec3(0.0f)) return;
  if (path.reflections == 0) return path.add(emission, 0, transport_.clamp);
  // Without shadows the ray may have missed what hides behind others: aiming alone finds it all.
  if (!transport_.emissive_lighting || !transport_.shadows) return;
  const float other = world_.lights.pdf_sr_emitter(path.chances, hit, vertex.point, path.ray.direction);
  path.add(balance(path.pdf_sr, other) * emission, path.reflections, transport_.clamp);
}

void PathTracer::add_light(Path& path, const Vertex& vertex, const Draws& draws) const {
  const auto light = world_.lights.sample(path.receiver, path.chances, draws.light, draws.light_place);
  if (!light) return;
  const shading::Surface& s = vertex.look.surface;
  const bool delta = light->pdf_sr == 0.0f;
  const float alpha = delta ? std::max(vertex.alpha, transport_.min_highlight_alpha) : vertex.alpha;
  vec3 reflected =
      shading::evaluate_brdf(s, alpha, vertex.wo, light->wi, vertex.specular_scale, transport_.model) * light->light;
  if (reflected == vec3(0.0f)) return;
  reflected *= arriving(path, vertex, *light);
  if (reflected == vec3(0.0f)) return;
  if (!delta && (transport_.shadows || !light->emitter))
    reflected *= balance(light->pdf_sr,
                         pdf_sr_brdf(s, vertex.alpha, vertex.wo, light->wi, vertex.specular_scale, transport_.model));
  path.add(reflected, path.reflections + 1, transport_.clamp);
}

// What multiplies light on its way from the light.
vec3 PathTracer::arriving(const Path& path, const Vertex& vertex, const LightSample& light) const {
  if (!transport_.shadows || !light.shadowed) return vec3(1.0f);
  if (glm::dot(light.wi, vertex.outside) <= 0.0f) return vec3(0.0f);
  Ray ray;
  ray.origin = vertex.start();
  ray.direction = light.wi;
  if (!std::isinf(light.distance)) {
    // The start was moved off the surface: from there the same point lies in a slightly different direction.
    const vec3 way = vertex.point.position_ws + light.distance * light.wi - ray.origin;
    ray.to = glm::length(way);
    ray.direction = way / ray.to;
  }
  ray.cone_width_m = vertex.cone_width_m;
  ray.cone_spread = path.ray.cone_spread;
  ray.chance = shading::hash_u32(path.chance + 1u);
  return world_.geometry.transmitted(ray);
}

bool PathTracer::reflect(Path& path, const Vertex& vertex, const Draws& draws) const {
  if (path.reflections + 1 == transport_.reflections && !anything_to_find(path)) return false;
  const auto next = sample_brdf(vertex.look.surface, vertex.alpha, vertex.wo, vertex.specular_scale, transport_.model,
                                draws.lobe, draws.direction);
  // What is not a number (vertex colours may be such) goes no further.
  if (!next || !(next->pdf_sr > 0.0f)) return false;
  path.throughput *= next->weight;
  path.pdf_sr = next->pdf_sr;
  ++path.reflections;
  path.ray = {.origin = vertex.start(),
              .direction = next->wi,
              .cone_width_m = vertex.cone_width_m,
              .cone_spread = std::max(path.ray.cone_spread, kConeShare / std::sqrt(next->pdf_sr))};
  if (!transport_.shadows) {
    add_environment(path);
    add_spheres(path, {}, std::numeric_limits<float>::infinity());
  }
  if (glm::dot(next->wi, vertex.outside) <= 0.0f) {
    if (transport_.shadows) add_spheres(path, {}, 0.0f);  // those that nothing hides
    return false;
  }
  if (path.reflections <= kSafeReflections) return true;
  const float survival = std::min(shading::max_component(path.throughput), kMostSurvive);
  if (!(draws.survival < survival)) return false;
  path.throughput /= survival;
  return true;
}

bool PathTracer::anything_to_find(const Path& path) const {
  return path.chances.environment > 0.0f || path.chances.emitters > 0.0f || world_.lights.has_spheres();
}

}  // namespace velarium::reference
