#include "passes/sun_shadows/cascade_fit.hpp"

#include "core/assert.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::sun_shadows {
namespace {

// Depths are rounded outwards to this share of an octave.
constexpr double kStepsAnOctave = 4.0;
constexpr double kSmallestScene = 1e-6;  // metres
// The range keeps this share of its far depth where `longest` would end it before the scene begins.
constexpr double kNearestShare = 0.5;
// Space before and behind what a map sees, as a share of it, so that rounding cuts nothing off.
constexpr double kDepthGuard = 1e-3;

double step_down(double depth) {
  return std::exp2(std::floor(kStepsAnOctave * std::log2(depth)) / kStepsAnOctave);
}

double step_up(double depth) {
  return std::exp2(std::ceil(kStepsAnOctave * std::log2(depth)) / kStepsAnOctave);
}

// Depth on the axis and radius of the smallest sphere around a slice of a pyramid whose corners have the tangent
// sqrt(k2) from the axis. Wide slices are ruled by their far side alone.
glm::dvec2 pyramid_sphere(const DepthRange& slice, double k2) {
  const double near = slice.near, far = slice.far;
  if (k2 >= (far - near) / (far + near)) return {far, far * std::sqrt(k2)};
  const double center = 0.5 * (far + near) * (1.0 + k2);
  const double radius2 =
      (far - near) * (far - near) + 2.0 * (far * far + near * near) * k2 + (far + near) * (far + near) * k2 * k2;
  return {center, 0.5 * std::sqrt(radius2)};
}

}  // namespace

std::vector<double> split_depths(const DepthRange& range, int count, double lambda) {
  VEL_ASSERT(range.near > 0.0 && range.near < range.far && count > 0);
  std::vector<double> depths;
  for (int i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    const double even_ratio = range.near * std::pow(range.far / range.near, share);
    const double even_length = range.near + (range.far - range.near) * share;
    depths.push_back(lambda * even_ratio + (1.0 - lambda) * even_length);
  }
  return depths;
}

Sphere slice_sphere(const View& view, const DepthRange& slice) {
  const double k2 = glm::dot(view.half, view.half);
  if (view.perspective) {
    const auto sphere = pyramid_sphere(slice, k2);
    return {view.eye + sphere.x * view.forward, sphere.y};
  }
  const double half_depth = 0.5 * (slice.far - slice.near);
  return {view.eye + (slice.near + half_depth) * view.forward, std::sqrt(k2 + half_depth * half_depth)};
}

DepthRange visible_depths(const View& view, const Sphere& scene, double longest) {
  const double middle = glm::dot(scene.center - view.eye, view.forward);
  const double radius = std::max(scene.radius, kSmallestScene);
  double far = std::max(middle + radius, radius);
  if (longest > 0.0) far = std::min(far, longest);
  far = step_up(far);
  const double near = std::min(middle - radius, kNearestShare * far);
  return {near > kDepthRatio * far ? step_down(near) : 0.0, far};
}

Map fit_map(const glm::dmat3& axes, const Sphere& sphere, const MapLimits& limits) {
  Map map{.axes = axes, .size = limits.size};
  const double inner = 2.0 * (sphere.radius + limits.margin);
  // More by what the snapping moves the map.
  map.side = inner * limits.size / (limits.size - 2.0 * passes::kGuardTexels - 2.0);
  const glm::dvec3 center = axes * sphere.center;
  const double texel = map.texel();
  map.corner = glm::floor((glm::dvec2(center) - 0.5 * map.side) / texel) * texel;
  // The sphere may stand before or behind all that there is, which then is what the map sees of it.
  const double front = std::clamp(center.z + sphere.radius, limits.scene.low.z, limits.scene.high.z);
  map.z_near = std::min(limits.scene.high.z, front + limits.blocker_distance);
  // At the end of the scene no other map takes over: the map goes on by as much as that would need.
  const double end = limits.scene.low.z - 0.5 * static_cast<double>(shading::kCascadeBlend) * map.side;
  map.z_far = std::min(std::max(end, center.z - sphere.radius), map.z_near);
  const double guard = kDepthGuard * (map.z_near - map.z_far + sphere.radius);
  map.z_near += guard;
  map.z_far -= guard;
  return map;
}

bool covers(const Map& map, const Sphere& sphere, double margin) {
  const glm::dvec3 center = map.axes * sphere.center;
  const double needed = sphere.radius + margin;
  const glm::dvec2 low = glm::dvec2(center) - needed, high = glm::dvec2(center) + needed;
  return low.x >= map.corner.x && low.y >= map.corner.y && high.x <= map.corner.x + map.side &&
         high.y <= map.corner.y + map.side && center.z - sphere.radius >= map.z_far;
}

bool is_due(std::size_t map, std::uint64_t picture) {
  if (map < 2) return true;
  const std::uint64_t period = std::uint64_t{1} << (map - 1);
  return picture % period == period / 2 - 1;
}

}  // namespace velarium::sun_shadows
