#include "passes/far_shadows/state.hpp"

#include "passes/far_shadows/blur.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace velarium::far_shadows {
namespace {

// Each moment in a layer of its own, as every device can store to one channel of 32 bits. Half floats are too coarse: a
// square below 1/4 is rounded by 2^-14, hence a deviation of 2^-7 of what the map spans, 8 m of a kilometre, is noise.
constexpr VkFormat kMomentFormat = VK_FORMAT_R32_SFLOAT;
// With the depth that they are made of, and what is blurred along rows alone.
constexpr std::uint64_t kMomentBytes = 8 + 4 + 8;
constexpr VkFormat kStaticFormat = VK_FORMAT_D16_UNORM;
constexpr std::uint64_t kStaticBytes = 2;

// The deviation that rounding may feign, as a share of what the map spans: squares below 1/4 have steps of 2^-26, and a
// blur adds up some tens of them.
constexpr double kMomentRounding = 0x1p-12;
// A surface is not flat within a texel.
constexpr double kLeastDeviation = 0.5;  // texels
// The blur reaches as far as penumbrae of blockers of mean distance. Less than a texel would show texels, more than a
// few costs more than a smaller map.
constexpr double kMeanBlockerShare = 0.1;  // of the farthest distance
constexpr double kLeastBlur = 0.7, kMostBlur = 4.0;
// As long as the last cascade of the talk, which is drawn for every eighth picture [Crytek 2011].
constexpr int kMomentPictures = 8;

// What a depth of 16 bits is rounded by when it is stored, and when it is compared: a step each at most.
constexpr double kDepthStep = 1.0 / 65535.0;
constexpr double kStaticSteps = 2.0;

constexpr double kSmallestSide = 1e-6;  // metres
// Space before and behind what a map sees, as a share of it, so that rounding cuts nothing off.
constexpr double kDepthGuard = 1e-3;

constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

}  // namespace

passes::SunMap fit_to(const glm::dmat3& axes, const passes::LightBox& casters, int size, double guard) {
  const glm::dvec3 extent = casters.high - casters.low;
  passes::SunMap map{.axes = axes, .size = size};
  map.side = std::max({extent.x, extent.y, kSmallestSide}) * size / (size - 2.0 * guard);
  map.corner = 0.5 * (glm::dvec2(casters.low) + glm::dvec2(casters.high) - map.side);
  const double depth_guard = kDepthGuard * std::max(extent.z, map.side / size);
  map.z_near = casters.high.z + depth_guard;
  map.z_far = casters.low.z - depth_guard;
  return map;
}

FarShadow possible_kind(FarShadow wanted, const upload::CasterTable& casters) {
  return wanted == FarShadow::static_map && !upload::has_static(casters) ? FarShadow::off : wanted;
}

int possible_size(int wanted, std::uint32_t largest_image) {
  while (static_cast<std::uint32_t>(wanted) > largest_image) wanted /= 2;
  return wanted;
}

void State::allocate(gpu::Device& device, const gpu::ImageDesc& desc, VkImageUsageFlags usage) {
  if (image_ && image_.desc() == desc) return;
  stale_ = true;
  image_ = {};  // first: the old one and the new one need not fit beside each other
  image_ = gpu::Image(device, desc, usage | kRead);
}

void State::keep_or_draw(const Contents& contents, bool may_keep) {
  stale_ = !may_keep || contents != contents_;
  age_ = stale_ ? 1 : age_ + 1;
  contents_ = contents;
}

void State::fit_moments(gpu::Device& device, const upload::Tables& tables, const Settings& settings) {
  const glm::dmat3 axes = passes::sun_axes(tables);
  const auto box = passes::light_box(axes, upload::bounds_of(tables.casters));
  wanted_size_ = settings.size;
  const int size = possible_size(wanted_size_, device.caps().max_image_size);
  const auto map = fit_to(axes, box, size, passes::kGuardTexels + blur_radius(kMostBlur));
  const double distance = passes::blocker_distance(box, static_cast<double>(settings.max_blocker_distance));
  const auto penumbra = passes::widest_penumbra(tables, settings.soft, kMeanBlockerShare * distance, 0.5 * map.side);
  // A disc's deviation along one axis is half its radius.
  const double blur = std::clamp(0.5 * penumbra.radius / map.texel(), kLeastBlur, kMostBlur);
  keep_or_draw({.scene_id = tables.gpu->id(), .map = map, .blur_deviation = static_cast<float>(blur)},
               settings.update == MapUpdate::staggered && age_ < kMomentPictures);
  auto& cascade = table_.cascade;
  cascade = passes::gpu_cascade(map, tables.origin, penumbra);
  cascade.soft.w =
      static_cast<float>(std::max(kLeastDeviation * map.texel(), kMomentRounding * (map.z_near - map.z_far)));
  const auto side = static_cast<std::uint32_t>(size);
  allocate(device, {.format = kMomentFormat, .width = side, .height = side, .layers = 2, .array = true},
           VK_IMAGE_USAGE_STORAGE_BIT);
}

void State::fit_static(gpu::Device& device, const upload::Tables& tables, const Settings& settings) {
  const glm::dmat3 axes = passes::sun_axes(tables);
  const auto box = passes::light_box(axes, upload::bounds_of(tables.casters, upload::CasterChoice::static_only));
  wanted_size_ = settings.static_size;
  const int size = possible_size(wanted_size_, device.caps().max_image_size);
  const auto map = fit_to(axes, box, size, passes::kGuardTexels);
  keep_or_draw({.scene_id = tables.gpu->id(), .map = map, .slope_bias = settings.slope_bias},
               settings.update == MapUpdate::staggered);
  const double distance = passes::blocker_distance(box, static_cast<double>(settings.max_blocker_distance));
  auto& cascade = table_.cascade;
  cascade =
      passes::gpu_cascade(map, tables.origin, passes::widest_penumbra(tables, settings.soft, distance, 0.5 * map.side));
  cascade.soft.w = static_cast<float>(kStaticSteps * kDepthStep * (map.z_near - map.z_far));
  const auto side = static_cast<std::uint32_t>(size);
  allocate(device, {.format = kStaticFormat, .width = side, .height = side, .array = true},
           VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
}

void State::prepare(gpu::Device& device, const upload::Tables& tables, bool wanted, const Settings& settings) {
  const FarShadow kind = wanted ? possible_kind(settings.kind, tables.casters) : FarShadow::off;
  if (settings.kind == FarShadow::off || (!wanted && settings.update == MapUpdate::all)) *this = State();
  kind_ = kind;
  table_ = {.normal_offset = settings.normal_offset, .snap = static_cast<float>(passes::vertex_snap(device))};
  if (kind == FarShadow::vsm) fit_moments(device, tables, settings);
  if (kind == FarShadow::static_map) fit_static(device, tables, settings);
}

std::string State::note() const {
  if (kind_ == FarShadow::off || contents_.map.size >= wanted_size_) return {};
  return fmt::format("the map of far_shadows.kind={} has {} texels a side, as images of this device can have no more",
                     kind_ == FarShadow::vsm ? "vsm" : "static_map", contents_.map.size);
}

std::vector<MapMemory> State::memory() const {
  return {{"far_shadows.map", image_.bytes()}};
}

passes::MapDemand demand(FarShadow kind, const Settings& settings) {
  const bool is_static = kind == FarShadow::static_map;
  const std::uint64_t bytes = is_static ? kStaticBytes : kMomentBytes;
  return {is_static ? "far_shadows.static_size" : "far_shadows.size", is_static ? settings.static_size : settings.size,
          kind == FarShadow::off ? 0 : bytes};
}

}  // namespace velarium::far_shadows
