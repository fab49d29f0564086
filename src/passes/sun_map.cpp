#include "passes/sun_map.hpp"

#include "core/assert.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace velarium::passes {
namespace {

// A penumbra is no wider than this share of half of its map, or the map would serve little else.
constexpr double kWidestPenumbra = 0.5;

// Of the way that blockers may be distant on, metres: more than nothing, as it is divided by.
constexpr double kShortestDistance = 1e-6;

// Sine to tangent.
double tangent_of(float sine) {
  const double s = std::clamp(static_cast<double>(sine), 0.0, 0.99);
  return s / std::sqrt(1.0 - s * s);
}

const upload::GpuLight& sun_of(const upload::Tables& tables) {
  return tables.lights[tables.light_ranges.sun];
}

}  // namespace

glm::dmat3 light_axes(const glm::dvec3& to_sun) {
  // Any vector that is not parallel would do; the same one for all directions about it keeps maps from turning.
  const glm::dvec3 up = std::abs(to_sun.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 right = glm::normalize(glm::cross(up, to_sun));
  const glm::dvec3 down = glm::cross(right, to_sun);
  return glm::transpose(glm::dmat3(right, down, to_sun));
}

glm::dmat3 sun_axes(const upload::Tables& tables) {
  return light_axes(glm::normalize(-glm::dvec3(sun_of(tables).direction)));
}

LightBox light_box(const glm::dmat3& axes, const scene::WorldAabb& bounds) {
  VEL_ASSERT(!bounds.empty());
  LightBox box{glm::dvec3(std::numeric_limits<double>::infinity()),
               glm::dvec3(-std::numeric_limits<double>::infinity())};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                        (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                        (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
    box.low = glm::min(box.low, axes * at);
    box.high = glm::max(box.high, axes * at);
  }
  return box;
}

double blocker_distance(const LightBox& casters, double longest) {
  return std::clamp(casters.high.z - casters.low.z, kShortestDistance, longest);
}

glm::mat4 clip_from_world(const SunMap& map, const glm::dvec3& origin) {
  const glm::dvec3 at_origin = map.axes * origin;
  const double scale = 2.0 / map.side, depth_scale = 1.0 / (map.z_near - map.z_far);
  const glm::dmat3 rows = glm::transpose(map.axes);
  const glm::dvec3 offset((at_origin.x - map.corner.x) * scale - 1.0, (at_origin.y - map.corner.y) * scale - 1.0,
                          (at_origin.z - map.z_far) * depth_scale);
  const glm::dmat4 transposed(glm::dvec4(rows[0] * scale, offset.x), glm::dvec4(rows[1] * scale, offset.y),
                              glm::dvec4(rows[2] * depth_scale, offset.z), glm::dvec4(0.0, 0.0, 0.0, 1.0));
  return glm::mat4(glm::transpose(transposed));
}

std::vector<glm::dvec4> caster_planes(const SunMap& map) {
  const glm::dmat3 rows = glm::transpose(map.axes);
  const glm::dvec2 end = map.corner + map.side;
  return {
      {rows[0], -map.corner.x}, {-rows[0], end.x}, {rows[1], -map.corner.y}, {-rows[1], end.y}, {rows[2], -map.z_far}};
}

Penumbra widest_penumbra(const upload::Tables& tables, bool soft, double distance, double half_side) {
  const double tangent = soft ? tangent_of(sun_of(tables).color.w) : 0.0;
  const double radius = std::min(tangent * distance, kWidestPenumbra * half_side);
  return {radius, tangent > 0.0 ? radius / tangent : distance};
}

shading::Cascade gpu_cascade(const SunMap& map, const glm::dvec3& origin, const Penumbra& widest) {
  const glm::dvec3 at_origin = map.axes * origin;
  const double span = map.z_near - map.z_far, texel = map.texel();
  return {.place = glm::dvec4(1.0, at_origin.x - map.corner.x, at_origin.y - map.corner.y,
                              widest.radius + kGuardTexels * texel) /
                   map.side,
          .depth = glm::dvec4(1.0 / span, (at_origin.z - map.z_far) / span, span, texel),
          .soft = {std::max(widest.radius, texel) / map.side, widest.distance, texel / map.side, 0.0}};
}

double vertex_snap(const gpu::Device& device) {
  return std::ldexp(std::numbers::sqrt2, -1 - static_cast<int>(device.caps().sub_pixel_bits));
}

void draw_sun_map(graph::Context& c, const upload::Tables& tables, const SunMap& map, const SunMapDraw& how) {
  const upload::CasterView view{.clip_from_world = clip_from_world(map, tables.origin),
                                .state = {.depth_format = how.depth_format, .depth_clamp = true, .depth_bias = true}};
  const auto planes = caster_planes(map);
  for (const auto kind : {upload::CasterKind::opaque, upload::CasterKind::cutout})
    upload::draw_casters(c.tools(), c.commands(), tables,
                         upload::visible_casters(tables.casters, kind, planes, how.casters), kind, view);
}

}  // namespace velarium::passes
