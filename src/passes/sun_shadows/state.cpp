#include "passes/sun_shadows/state.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::sun_shadows {
namespace {

constexpr std::uint64_t kDepthBytes = 4, kTranslucencyBytes = 8;  // a texel

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

Sphere sphere_around(const scene::WorldAabb& bounds) {
  return {0.5 * (bounds.min + bounds.max), 0.5 * glm::length(bounds.max - bounds.min)};
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

Served serve(const upload::Tables& tables, const View& view, const Settings& settings, bool static_map) {
  auto served = served_spheres(view, sphere_around(upload::bounds_of(tables.casters)), settings);
  if (static_map) leave_to_static_map(served);
  return served;
}

bool wants_maps(const upload::Tables& tables, const Settings& settings) {
  return settings.enabled && tables.light_ranges.sun != upload::kNoSun && !tables.casters.casters.empty();
}

}  // namespace

Demand demand(const upload::Tables& tables, const upload::ViewMatrices& view, const Settings& settings,
              bool static_map) {
  if (!wants_maps(tables, settings)) return {.maps = {"sun_shadows.size", settings.size}};
  const auto served = serve(tables, fit_view(view), settings, static_map);
  const bool translucent = settings.translucent && upload::has_translucent(tables.casters);
  const std::uint64_t texel = kDepthBytes + (translucent ? kTranslucencyBytes : 0);
  return {{"sun_shadows.size", settings.size, served.spheres.size() * texel}, true, served.whole};
}

// There is a sun that casts shadows.
void State::fit_all(const upload::Tables& tables, const View& view, const Settings& settings, bool static_map) {
  const glm::dmat3 axes = passes::sun_axes(tables);
  MapLimits limits{.scene = passes::light_box(axes, upload::bounds_of(tables.casters)), .size = settings.size};
  limits.blocker_distance = passes::blocker_distance(limits.scene, static_cast<double>(settings.max_blocker_distance));

  const auto served = serve(tables, view, settings, static_map);
  hold_scene_ = served.whole;
  const auto& spheres = served.spheres;
  const bool translucent = settings.translucent && upload::has_translucent(tables.casters);
  const Shared shared{tables.gpu->id(), tables.casters.casters.size(), axes,       settings.size,
                      spheres.size(),   settings.slope_bias,           translucent};
  const bool keeps = settings.update == MapUpdate::staggered && shared == shared_ && depths_;
  pictures_ = keeps ? pictures_ + 1 : 0;
  shared_ = shared;

  const glm::dmat3 rows = glm::transpose(axes);
  table_ = {.axis_x = glm::dvec4(rows[0], 0.0),
            .axis_y = glm::dvec4(rows[1], 0.0),
            .axis_z = glm::dvec4(rows[2], settings.normal_offset)};
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto penumbra = passes::widest_penumbra(tables, settings.soft, limits.blocker_distance, spheres[i].radius);
    limits.margin = penumbra.radius;
    const bool keep = keeps && !is_due(i, pictures_) && covers(maps_[i], spheres[i], limits.margin);
    const double room = settings.update == MapUpdate::staggered ? kRoom : 1.0;
    if (i == maps_.size()) maps_.emplace_back();
    if (!keep) maps_[i] = fit_map(axes, {spheres[i].center, spheres[i].radius * room}, limits);
    stale_.push_back(!keep);
    table_.cascades[table_.cascade_count++] = gpu_cascade(maps_[i], tables.origin, penumbra);
  }
  maps_.resize(spheres.size());
  note_translucency(tables.casters);
}

// Maps that are kept stay as they are.
void State::note_translucency(const upload::CasterTable& casters) {
  translucent_.resize(maps_.size());
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    if (stale_[i])
      translucent_[i] =
          shared_.translucent &&
          !upload::visible_casters(casters, upload::CasterKind::translucent, caster_planes(maps_[i])).empty();
    if (translucent_[i]) table_.translucent |= 1u << i;
  }
}

void State::prepare(gpu::Device& device, const upload::Tables& tables, const upload::ViewMatrices& view,
                    const Settings& settings, bool static_map) {
  stale_.clear();
  table_ = {};
  if (!wants_maps(tables, settings)) {
    *this = State();
    return;
  }
  const auto size = static_cast<std::uint32_t>(settings.size);
  if (size > device.caps().max_image_size)
    throw Error(ErrorCode::usage, fmt::format("sun_shadows.size {} is more than this device's images have, {}", size,
                                              device.caps().max_image_size));
  fit_all(tables, fit_view(view), settings, static_map);
  table_.axis_x.w = static_cast<float>(passes::vertex_snap(device));
  allocate(device, size);
}

void State::allocate(gpu::Device& device, std::uint32_t size) {
  gpu::ImageDesc desc{.format = kFormat,
                      .width = size,
                      .height = size,
                      .layers = static_cast<std::uint32_t>(maps_.size()),
                      .array = true};
  constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  // The old ones and the new ones need not fit beside each other.
  if (depths_.desc() != desc) {
    depths_ = {};
    translucency_ = {};
  }
  if (!depths_) depths_ = gpu::Image(device, desc, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | kRead);
  desc.format = upload::kTranslucencyFormat;
  if (std::find(translucent_.begin(), translucent_.end(), true) == translucent_.end())
    translucency_ = {};
  else if (!translucency_)
    translucency_ = gpu::Image(device, desc, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | kRead);
}

std::vector<MapMemory> State::memory() const {
  return {{"sun_shadows.cascades", depths_.bytes()}, {"sun_translucency.cascades", translucency_.bytes()}};
}

}  // namespace velarium::sun_shadows
