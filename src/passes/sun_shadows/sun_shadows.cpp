#include "passes/sun_shadows/sun_shadows.hpp"

#include "graph/context.hpp"
#include "upload/transfer.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace velarium::sun_shadows {
namespace {

using graph::Access;

constexpr VkFormat kFormat = VK_FORMAT_D32_SFLOAT;

// A penumbra is no wider than this share of the radius of what its map serves, or the map would serve little else.
constexpr double kWidestPenumbra = 0.5;
// Of the way that blockers may be distant on, metres: more than nothing, as it is divided by.
constexpr double kShortestReach = 1e-6;
// Maps that are kept are larger than what they serve, so that a view that moves stays inside for a while.
constexpr double kRoom = 1.1;

View fit_view(const upload::ViewMatrices& view) {
  const auto& projection = view.clip_from_view;
  return {.eye = view.eye,
          .forward = glm::dvec3(-glm::transpose(view.view_from_world)[2]),
          .half = 1.0 / glm::abs(glm::dvec2(projection[0][0], projection[1][1])),
          .perspective = projection[3][3] == 0.0f};
}

scene::Aabb bounds_of(const upload::CasterTable& table) {
  scene::Aabb bounds;
  for (const auto& caster : table.casters) bounds.add(caster.bounds);
  return bounds;
}

Sphere sphere_around(const scene::Aabb& bounds) {
  const glm::dvec3 low(bounds.min), high(bounds.max);
  return {0.5 * (low + high), 0.5 * glm::length(high - low)};
}

// The extent of a box in light space along each axis.
void set_extent(const scene::Aabb& bounds, const glm::dmat3& axes, MapLimits& limits) {
  limits.scene_low = glm::dvec3(std::numeric_limits<double>::infinity());
  limits.scene_high = -limits.scene_low;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                        (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                        (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
    limits.scene_low = glm::min(limits.scene_low, axes * at);
    limits.scene_high = glm::max(limits.scene_high, axes * at);
  }
}

// What maps serve, near to far: a slice of the view each. The whole scene is enough for the last of them, and for all
// where it is smaller than a slice.
std::vector<Sphere> served_spheres(const View& view, const Sphere& scene, const Settings& settings) {
  const auto range = visible_depths(view, scene, static_cast<double>(settings.distance));
  auto depths = split_depths({std::max(range.near, kDepthRatio * range.far), range.far}, settings.cascades,
                             static_cast<double>(settings.split));
  depths.front() = range.near;
  std::vector<Sphere> spheres;
  for (int i = 0; i < settings.cascades; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Sphere slice = slice_sphere(view, {depths[at], depths[at + 1]});
    if (slice.radius >= scene.radius) {
      spheres.push_back(scene);
      break;
    }
    spheres.push_back(slice);
  }
  return spheres;
}

// Sine to tangent.
double tangent_of(float sine) {
  const double s = std::clamp(static_cast<double>(sine), 0.0, 0.99);
  return s / std::sqrt(1.0 - s * s);
}

void draw_map(graph::Context& c, const upload::SceneTables& scene, const Map& map, const glm::dvec3& eye) {
  const upload::CasterView view{.clip_from_world = clip_from_world(map, eye),
                                .state = {.depth_format = kFormat, .depth_clamp = true, .depth_bias = true}};
  const auto planes = caster_planes(map);
  for (const auto kind : {upload::CasterKind::opaque, upload::CasterKind::cutout})
    upload::draw_casters(c.tools(), c.commands(), scene, upload::visible_casters(scene.casters, kind, planes), kind,
                         view);
}

}  // namespace

// Maps and what shaders know of them, by the sun of the scene. There is one that casts shadows.
shading::SunShadows Maps::fit_all(const upload::SceneTables& scene, const View& view, const Settings& settings) {
  const auto& sun = scene.host_lights[scene.light_ranges.sun];
  const glm::dmat3 axes = light_axes(glm::normalize(-glm::dvec3(sun.direction)));
  const auto bounds = bounds_of(scene.casters);
  MapLimits limits{.size = settings.size};
  set_extent(bounds, axes, limits);
  limits.reach =
      std::clamp(limits.scene_high.z - limits.scene_low.z, kShortestReach, static_cast<double>(settings.reach));
  const double tangent = settings.soft ? tangent_of(sun.color.w) : 0.0;

  const auto spheres = served_spheres(view, sphere_around(bounds), settings);
  const Shared shared{scene.gpu, scene.casters.casters.size(), axes, settings.size, spheres.size()};
  const bool keeps = settings.update == MapUpdate::staggered && shared == shared_ && depths_;
  pictures_ = keeps ? pictures_ + 1 : 0;
  shared_ = shared;

  const glm::dmat3 rows = glm::transpose(axes);
  shading::SunShadows table{.axis_x = glm::dvec4(rows[0], 0.0),
                            .axis_y = glm::dvec4(rows[1], 0.0),
                            .axis_z = glm::dvec4(rows[2], settings.normal_offset)};
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    limits.margin = std::min(tangent * limits.reach, kWidestPenumbra * spheres[i].radius);
    const double distance = tangent > 0.0 ? limits.margin / tangent : limits.reach;
    const bool keep = keeps && !is_due(i, pictures_) && covers(maps_[i], spheres[i], limits.margin);
    const double room = settings.update == MapUpdate::staggered ? kRoom : 1.0;
    if (i == maps_.size()) maps_.emplace_back();
    if (!keep) maps_[i] = fit_map(axes, {spheres[i].center, spheres[i].radius * room}, limits);
    stale_.push_back(!keep);
    table.cascades[table.cascade_count++] = gpu_cascade(maps_[i], view.eye, {limits.margin, distance});
  }
  maps_.resize(spheres.size());
  return table;
}

void Maps::fit(gpu::Device& device, upload::SceneTables& scene, const upload::ViewMatrices& view,
               const Settings& settings) {
  stale_.clear();
  const bool wanted = settings.enabled && scene.light_ranges.sun != upload::kNoSun && !scene.casters.casters.empty();
  const auto size = static_cast<std::uint32_t>(settings.size);
  if (wanted && size > device.caps().max_image_size)
    throw Error(ErrorCode::usage, fmt::format("sun_shadows.size {} is more than this device's images have, {}", size,
                                              device.caps().max_image_size));
  eye_ = view.eye;
  std::vector<shading::SunShadows> table(1);
  if (wanted) {
    table.front() = fit_all(scene, fit_view(view), settings);
  } else {
    maps_.clear();
    shared_ = {};
  }
  scene.sun_shadows = upload::make_buffer(device, table, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const gpu::ImageDesc desc{.format = kFormat,
                            .width = wanted ? size : 1,
                            .height = wanted ? size : 1,
                            .layers = std::max(static_cast<std::uint32_t>(maps_.size()), 1u),
                            .array = true};
  if (depths_ && depths_.desc() == desc) return;
  depths_ = gpu::Image(
      device, desc,
      VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
}

graph::GraphImage add(graph::Graph& graph, const Inputs& in) {
  // Layers that are not drawn hold what was drawn before, or a texel that nothing reads.
  const auto kept = graph.import("sun_shadows.cascades", in.maps.depths(), true);
  if (!in.first || in.maps.empty()) return kept;
  auto& pass = graph.pass("sun_shadows");
  const auto depths = pass.write(kept, Access::depth_attachment);
  pass.run([in, depths](graph::Context& c) {
    const auto& maps = in.maps.maps();
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
      if (!in.maps.is_stale(i)) continue;
      c.begin_rendering({.depth = depths, .clear_depth = true, .layer = i});
      // Away from the sun, which is towards 0: depth is reversed.
      vkCmdSetDepthBias(c.commands(), 0.0f, 0.0f, -in.slope_bias);
      draw_map(c, in.scene, maps[i], in.maps.eye());
      c.end_rendering();
    }
  });
  return depths;
}

}  // namespace velarium::sun_shadows
