#include "passes/sun_shadows/sun_shadows.hpp"

#include "graph/context.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::sun_shadows {
namespace {

using graph::Access;
using upload::CasterKind;

constexpr VkFormat kFormat = VK_FORMAT_D32_SFLOAT;

// Maps that are kept are larger than what they serve, so that a view that moves stays inside for a while.
constexpr double kRoom = 1.1;

View fit_view(const upload::ViewMatrices& view) {
  const auto& projection = view.clip_from_view;
  return {.eye = view.eye,
          .forward = glm::dvec3(-glm::transpose(view.view_from_world)[2]),
          .half = 1.0 / glm::abs(glm::dvec2(projection[0][0], projection[1][1])),
          .perspective = projection[3][3] == 0.0f};
}

Sphere sphere_around(const scene::Aabb& bounds) {
  const glm::dvec3 low(bounds.min), high(bounds.max);
  return {0.5 * (low + high), 0.5 * glm::length(high - low)};
}

// How many maps the static map replaces, the last ones [Schulz 2014, Ryse: the fourth and the fifth].
constexpr std::size_t kReplacedMaps = 2;

// What maps serve, near to far: a slice of the view each.
struct Served {
  std::vector<Sphere> spheres;
  bool whole = false;  // is every surface of the scene that can be seen in one of them?
};

// The whole scene is enough for the last of them, and for all where it is smaller than a slice.
Served served_spheres(const View& view, const Sphere& scene, const Settings& settings) {
  const auto range = visible_depths(view, scene, static_cast<double>(settings.distance));
  auto depths = split_depths({std::max(range.near, kDepthRatio * range.far), range.far}, settings.cascades,
                             static_cast<double>(settings.split));
  depths.front() = range.near;
  Served served{.whole = range.far >= visible_depths(view, scene, 0.0).far};
  for (int i = 0; i < settings.cascades; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Sphere slice = slice_sphere(view, {depths[at], depths[at + 1]});
    if (slice.radius >= scene.radius) {
      served.spheres.push_back(scene);
      served.whole = true;
      break;
    }
    served.spheres.push_back(slice);
  }
  return served;
}

// One is left for what moves, and is in no static map.
void leave_to_static_map(Served& served) {
  const std::size_t count = served.spheres.size();
  if (count < 2) return;
  served.spheres.resize(count - std::min(kReplacedMaps, count - 1));
  served.whole = false;
}

Served serve(const upload::SceneTables& scene, const View& view, const Settings& settings) {
  auto served = served_spheres(view, sphere_around(upload::bounds_of(scene.casters)), settings);
  if (settings.far == FarSun::static_map && upload::has_still(scene.casters)) leave_to_static_map(served);
  return served;
}

bool wants_maps(const upload::SceneTables& scene, const Settings& settings) {
  return settings.enabled && scene.light_ranges.sun != upload::kNoSun && !scene.casters.casters.empty();
}

// Beside maps whose depths are drawn.
void add_veils(graph::Graph& graph, const Inputs& in, Outputs& out) {
  auto& pass = graph.pass("sun_veils");
  pass.read(out.depths, Access::depth_test);
  out.veils = pass.write(out.veils, Access::color_attachment);
  pass.run([in, out](graph::Context& c) {
    const auto& maps = in.maps.maps();
    const auto& size = c.image(out.veils).desc();
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
      if (!in.maps.is_stale(i) || !in.maps.is_veiled(i)) continue;
      c.begin_rendering({.colors = {{out.veils}}, .depth = out.depths, .depth_writable = false, .layer = i});
      c.clear_color({0, 0, size.width, size.height}, upload::kNoVeil);
      const upload::CasterView view{.clip_from_world = clip_from_world(maps[i], in.maps.eye()),
                                    .state = upload::veil_state(kFormat, true)};
      upload::draw_casters(c.tools(), c.commands(), in.scene,
                           upload::visible_casters(in.scene.casters, CasterKind::translucent, caster_planes(maps[i])),
                           CasterKind::translucent, view);
      c.end_rendering();
    }
  });
}

}  // namespace

Demand demand(const upload::SceneTables& scene, const upload::ViewMatrices& view, const Settings& settings) {
  if (!wants_maps(scene, settings)) return {};
  const auto served = serve(scene, fit_view(view), settings);
  return {static_cast<std::uint32_t>(served.spheres.size()), served.whole};
}

// Maps and what shaders know of them, by the sun of the scene. There is one that casts shadows.
shading::SunShadows Maps::fit_all(const upload::SceneTables& scene, const View& view, const Settings& settings) {
  const glm::dmat3 axes = passes::sun_axes(scene);
  MapLimits limits{.scene = passes::light_box(axes, upload::bounds_of(scene.casters)), .size = settings.size};
  limits.reach = passes::blocker_reach(limits.scene, static_cast<double>(settings.reach));

  const auto served = serve(scene, view, settings);
  hold_scene_ = served.whole;
  const auto& spheres = served.spheres;
  const bool translucent = settings.translucent && upload::has_translucent(scene.casters);
  const Shared shared{scene.gpu->id(), scene.casters.casters.size(), axes,       settings.size,
                      spheres.size(),  settings.slope_bias,          translucent};
  const bool keeps = settings.update == MapUpdate::staggered && shared == shared_ && depths_;
  pictures_ = keeps ? pictures_ + 1 : 0;
  shared_ = shared;

  const glm::dmat3 rows = glm::transpose(axes);
  shading::SunShadows table{.axis_x = glm::dvec4(rows[0], 0.0),
                            .axis_y = glm::dvec4(rows[1], 0.0),
                            .axis_z = glm::dvec4(rows[2], settings.normal_offset)};
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto penumbra = passes::widest_penumbra(scene, settings.soft, limits.reach, spheres[i].radius);
    limits.margin = penumbra.radius;
    const bool keep = keeps && !is_due(i, pictures_) && covers(maps_[i], spheres[i], limits.margin);
    const double room = settings.update == MapUpdate::staggered ? kRoom : 1.0;
    if (i == maps_.size()) maps_.emplace_back();
    if (!keep) maps_[i] = fit_map(axes, {spheres[i].center, spheres[i].radius * room}, limits);
    stale_.push_back(!keep);
    table.cascades[table.cascade_count++] = gpu_cascade(maps_[i], view.eye, penumbra);
  }
  maps_.resize(spheres.size());
  note_veils(scene.casters, table);
  return table;
}

// Maps that are kept stay veiled as they are.
void Maps::note_veils(const upload::CasterTable& casters, shading::SunShadows& table) {
  veiled_.resize(maps_.size());
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    if (stale_[i])
      veiled_[i] = shared_.translucent &&
                   !upload::visible_casters(casters, CasterKind::translucent, caster_planes(maps_[i])).empty();
    if (veiled_[i]) table.veiled |= 1u << i;
  }
}

void Maps::fit(gpu::Device& device, upload::SceneTables& scene, const upload::ViewMatrices& view,
               const Settings& settings) {
  stale_.clear();
  const bool wanted = wants_maps(scene, settings);
  const auto size = static_cast<std::uint32_t>(settings.size);
  if (wanted && size > device.caps().max_image_size)
    throw Error(ErrorCode::usage, fmt::format("sun_shadows.size {} is more than this device's images have, {}", size,
                                              device.caps().max_image_size));
  eye_ = view.eye;
  scene.host_sun_shadows = {};
  if (wanted) {
    scene.host_sun_shadows = fit_all(scene, fit_view(view), settings);
    // Half of what vertices snap to, on both axes.
    scene.host_sun_shadows.axis_x.w =
        std::ldexp(std::numbers::sqrt2_v<float>, -1 - static_cast<int>(device.caps().sub_pixel_bits));
  } else {
    maps_.clear();
    veiled_.clear();
    shared_ = {};
  }
  allocate(device, wanted ? size : 1);
}

void Maps::allocate(gpu::Device& device, std::uint32_t size) {
  gpu::ImageDesc desc{.format = kFormat,
                      .width = size,
                      .height = size,
                      .layers = std::max(static_cast<std::uint32_t>(maps_.size()), 1u),
                      .array = true};
  constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  // The old ones and the new ones need not fit beside each other.
  if (depths_.desc() != desc) {
    depths_ = {};
    veils_ = {};
  }
  if (!depths_) depths_ = gpu::Image(device, desc, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | kRead);
  desc.format = upload::kVeilFormat;
  if (std::find(veiled_.begin(), veiled_.end(), true) == veiled_.end())
    veils_ = {};
  else if (!veils_)
    veils_ = gpu::Image(device, desc, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | kRead);
}

Outputs add(graph::Graph& graph, const Inputs& in) {
  // Layers that are not drawn hold what was drawn before, or a texel that nothing reads.
  Outputs out{.depths = graph.import("sun_shadows.cascades", in.maps.depths(), true)};
  if (in.maps.veils()) out.veils = graph.import("sun_veils.cascades", in.maps.veils(), true);
  if (!in.first || in.maps.empty()) return out;
  auto& pass = graph.pass("sun_shadows");
  out.depths = pass.write(out.depths, Access::depth_attachment);
  pass.run([in, depths = out.depths](graph::Context& c) {
    const auto& maps = in.maps.maps();
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
      if (!in.maps.is_stale(i)) continue;
      c.begin_rendering({.depth = depths, .clear_depth = true, .layer = i});
      // Away from the sun, which is towards 0: depth is reversed.
      vkCmdSetDepthBias(c.commands(), 0.0f, 0.0f, -in.slope_bias);
      passes::draw_sun_map(c, in.scene, maps[i], in.maps.eye(), {.depth_format = kFormat});
      c.end_rendering();
    }
  });
  if (in.maps.veils()) add_veils(graph, in, out);
  return out;
}

}  // namespace velarium::sun_shadows
