#include "passes/local_shadows/views.hpp"

#include "passes/local_shadows/nearest_caster.hpp"
#include "shading/host.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

namespace velarium::local_shadows {
namespace {

using glm::dvec3;
using shading::GpuLight;

// What stands nearer to a light than this throws no shadow: depth would have no digits left for what is far. The nearer
// of a length and a share of how far the light reaches.
constexpr double kNear = 0.01, kNearShare = 1e-3;

// A cone of no width still has a map.
constexpr double kLeastTangent = 0.01;

// Bounds are widened by this share of their size, so that flat scenes have an inside.
constexpr double kBoundsSlack = 1e-3;

struct Box {
  dvec3 low, high;
};

Box relative_box(const scene::WorldAabb& box, const dvec3& origin) {
  return {box.min - origin, box.max - origin};
}

Box bounds_of(const upload::CasterTable& casters, const dvec3& origin) {
  scene::WorldAabb all;
  for (const auto& caster : casters.casters) all.add(caster.bounds);
  Box box = relative_box(all, origin);
  const dvec3 slack(kBoundsSlack * glm::length(box.high - box.low));
  return {box.low - slack, box.high + slack};
}

double farthest_corner(const Box& box, const dvec3& from) {
  return glm::length(glm::max(glm::abs(box.low - from), glm::abs(box.high - from)));
}

bool reaches(const Box& box, const dvec3& from, double radius) {
  const dvec3 off = glm::max(glm::max(box.low - from, from - box.high), dvec3(0.0));
  return glm::dot(off, off) < radius * radius;
}

// Right-handed: right x down = forward.
std::array<dvec3, 3> face_axes(std::uint32_t face) {
  const dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  switch (face) {
    case 0:
      return {y, z, x};
    case 1:
      return {z, y, -x};
    case 2:
      return {z, x, y};
    case 3:
      return {x, z, -y};
    case 4:
      return {x, y, z};
    default:
      return {y, x, -z};
  }
}

std::array<dvec3, 3> cone_axes(const GpuLight& light) {
  shading::vec3 right, down;
  const shading::vec3 forward(light.direction);
  shading::tangent_frame(forward, right, down);
  return {dvec3(right), dvec3(down), dvec3(forward)};
}

double half_tangent_of(const GpuLight& light) {
  if (!shading::has_one_view(light)) return 1.0;
  const double cosine = static_cast<double>(light.cone.z);
  return std::max(std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) / cosine, kLeastTangent);
}

// May the cone of a wide spot reach this face? A face's corners are acos(1 / sqrt 3) from its axis.
bool cone_reaches(const GpuLight& light, const dvec3& axis) {
  constexpr double kCornerAngle = 0.95531661812450928;
  if (!shading::is_spot(light) || shading::has_one_view(light)) return true;
  const double between = std::acos(std::clamp(glm::dot(dvec3(glm::vec3(light.direction)), axis), -1.0, 1.0));
  return between < std::acos(std::clamp(static_cast<double>(light.cone.z), 0.0, 1.0)) + kCornerAngle;
}

struct NearCasters {
  std::vector<scene::WorldAabb> solids, translucent;  // opaque ones and cutouts; translucent ones
};

// What all lights of a picture share.
struct Surroundings {
  const Viewer& viewer;
  const upload::CasterTable& casters;
  bool translucent;  // do such casters count?
  Box bounds;
  Solid seen, scene;
  glm::dmat4 clip_from_world;

  Surroundings(const Viewer& viewer_in, const upload::CasterTable& casters_in, bool translucent_in)
      : viewer(viewer_in),
        casters(casters_in),
        translucent(translucent_in),
        bounds(bounds_of(casters_in, viewer_in.origin)) {
    const dvec3 eye = viewer.eye();
    seen = view_solid(viewer.view, eye, farthest_corner(bounds, eye));
    scene = box_solid(bounds.low, bounds.high);
    glm::dmat4 view_from_world(glm::dmat3(viewer.view.view_from_world));
    view_from_world[3] = glm::dvec4(-(glm::dmat3(viewer.view.view_from_world) * eye), 1.0);
    clip_from_world = glm::dmat4(viewer.view.clip_from_view) * view_from_world;
  }

  [[nodiscard]] bool sees_sphere(const dvec3& center, double radius) const {
    return std::all_of(seen.begin(), seen.end(),
                       [&](const Side& side) { return glm::dot(dvec3(side.plane), center) + side.plane.w >= -radius; });
  }

  // What a light's sphere holds, as boxes.
  [[nodiscard]] NearCasters casters_around(const dvec3& position, double reach) const {
    NearCasters found;
    for (const auto& caster : casters.casters) {
      const bool is_translucent = caster.kind == upload::CasterKind::translucent;
      if (is_translucent && !translucent) continue;
      const Box box = relative_box(caster.bounds, viewer.origin);
      if (reaches(box, position, reach))
        (is_translucent ? found.translucent : found.solids).push_back({box.low, box.high});
    }
    return found;
  }
};

std::vector<scene::WorldAabb> inside(const Solid& solid, const std::vector<scene::WorldAabb>& boxes) {
  std::vector<glm::dvec4> planes;
  for (const auto& side : solid) planes.push_back(side.plane);
  std::vector<scene::WorldAabb> found;
  std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(found),
               [&](const auto& box) { return upload::overlaps(planes, box); });
  return found;
}

// Of boxes that reach before the near plane no tangent is known: they may be anywhere.
TranslucentBounds translucent_bounds(const View& view, const std::vector<scene::WorldAabb>& boxes) {
  if (boxes.empty()) return {};
  const double all = view.half_tangent + static_cast<double>(view.kernel);
  TranslucentBounds bounds{view.reach, glm::dvec2(all), glm::dvec2(-all)};
  for (const auto& box : boxes)
    for (int i = 0; i < 8; ++i) {
      const dvec3 corner((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                         (i & 4) != 0 ? box.max.z : box.min.z);
      const dvec3 way = corner - view.position;
      const double depth = glm::dot(view.axes[2], way);
      const glm::dvec2 place(glm::dot(view.axes[0], way), glm::dot(view.axes[1], way));
      bounds.nearest = std::min(bounds.nearest, depth);
      bounds.low = depth > view.near ? glm::min(bounds.low, place / depth) : glm::dvec2(-all);
      bounds.high = depth > view.near ? glm::max(bounds.high, place / depth) : glm::dvec2(all);
    }
  bounds.nearest = std::max(bounds.nearest, view.near);
  return bounds;
}

// Casters farther away than the least kernel serves need not be found.
float kernel_of(const GpuLight& light, const View& view, const Surroundings& around) {
  const float radius = light.color.w;
  if (radius == 0.0f) return 0.0f;
  const double far = static_cast<double>(shading::kKernelMargin * radius / shading::kKernelStep);
  const double nearest = nearest_caster(around.casters, around.viewer.origin, view.position, view.near,
                                        std::max(far, view.near), around.translucent);
  return shading::widest_kernel(static_cast<float>(view.half_tangent), radius, static_cast<float>(nearest));
}

void add_views(const GpuLight& light, std::uint32_t index, const Surroundings& around, std::vector<View>& views) {
  const dvec3 position(glm::vec3(light.position_range));
  const double reach =
      std::min(static_cast<double>(shading::light_cull_radius(light)), farthest_corner(around.bounds, position));
  if (!(reach > 0.0) || !around.sees_sphere(position, reach)) return;
  const auto near = around.casters_around(position, reach);
  if (near.solids.empty() && near.translucent.empty()) return;
  const double half_tangent = half_tangent_of(light), radius = static_cast<double>(light.color.w);
  View view{.light = index,
            .position = position,
            .half_tangent = half_tangent,
            // What stands within a bulb, as the flame of a torch, hides nothing of it.
            .near = std::min(std::max(std::min(kNear, kNearShare * reach), radius), 0.5 * reach),
            .reach = reach,
            .kernel = 0.0f};
  view.kernel = kernel_of(light, view, around);
  const std::size_t first = views.size();
  double pixels = 0.0;
  for (view.face = 0; view.face < view_count(light); ++view.face) {
    view.axes = shading::has_one_view(light) ? cone_axes(light) : face_axes(view.face);
    if (!cone_reaches(light, view.axes[2])) continue;
    const double tangent = half_tangent + static_cast<double>(view.kernel);
    const Solid pyramid = pyramid_solid(position, view.axes, tangent, reach);
    const std::array<const Solid*, 3> solids{&around.seen, &pyramid, &around.scene};
    view.pixels = covered_share(solids, around.clip_from_world) * around.viewer.size.x * around.viewer.size.y;
    const auto translucent = inside(pyramid, near.translucent);
    if (view.pixels <= 0.0 || (translucent.empty() && inside(pyramid, near.solids).empty())) continue;
    view.translucent = translucent_bounds(view, translucent);
    pixels += view.pixels;
    views.push_back(view);
  }
  const double candela = static_cast<double>(shading::luminance(glm::vec3(light.color)));
  for (std::size_t i = first; i < views.size(); ++i) views[i].importance = candela * pixels;
}

}  // namespace

std::uint32_t view_count(const GpuLight& light) {
  return shading::has_one_view(light) ? 1 : 6;
}

std::vector<View> wanted_views(std::span<const GpuLight> lights, const Viewer& viewer,
                               const upload::CasterTable& casters, bool translucent) {
  std::vector<View> views;
  if (casters.casters.empty()) return views;
  const Surroundings around(viewer, casters, translucent);
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const bool casts = (lights[i].flags & shading::kLightCastsShadow) != 0;
    if (casts && !shading::is_directional(lights[i])) add_views(lights[i], i, around, views);
  }
  return views;
}

std::uint32_t wanted_size(const View& view, const Settings& settings) {
  const float octave =
      shading::wanted_tile_octave(static_cast<float>(view.pixels), static_cast<float>(settings.density));
  const auto largest = std::max(std::bit_floor(static_cast<std::uint32_t>(settings.largest)), kSmallestTile);
  const int rounded = std::clamp(static_cast<int>(std::lround(octave)), 0, 30);
  return std::clamp(1u << rounded, kSmallestTile, std::min(largest, atlas_side(settings)));
}

std::uint32_t atlas_side(const Settings& settings) {
  return std::bit_floor(static_cast<std::uint32_t>(settings.atlas));
}

}  // namespace velarium::local_shadows
