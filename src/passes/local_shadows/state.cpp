#include "passes/local_shadows/state.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace velarium::local_shadows {
namespace {

constexpr VkFormat kFormat = VK_FORMAT_D32_SFLOAT;
constexpr std::uint64_t kDepthBytes = 4, kTranslucencyBytes = 8;  // a texel

// Allocated once, for the largest picture and the smallest; translucency only while a view has any.
void allocate(State& state, gpu::Device& device, std::uint32_t side, bool translucent) {
  const std::uint32_t most = device.caps().max_image_size;
  if (side > most)
    throw Error(ErrorCode::usage,
                fmt::format("local_shadows.atlas is {} texels, more than this device's images have, {}", side, most));
  constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const gpu::ImageDesc depth{.format = kFormat, .width = side, .height = side};
  // The old ones and the new ones need not fit beside each other.
  if (state.atlas.desc() != depth) {
    state.atlas = {};
    state.translucency = {};
  }
  if (!state.atlas) state.atlas = gpu::Image(device, depth, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | kRead);
  const gpu::ImageDesc color{.format = upload::kTranslucencyFormat, .width = side, .height = side, .array = true};
  if (!translucent)
    state.translucency = {};
  else if (!state.translucency)
    state.translucency = gpu::Image(device, color, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | kRead);
}

bool is_translucent(const shading::ShadowView& view) {
  return view.tile.w != 0.0f;
}

std::vector<PlacedView> place(State& state, const upload::Tables& tables, const Viewer& viewer,
                              const Settings& settings) {
  const auto views = wanted_views(tables.lights, viewer, tables.casters, settings.translucent);
  if (settings.updates == 0 || !state.atlas || state.scene_id != tables.gpu->id()) state.keeper.forget();
  state.scene_id = tables.gpu->id();
  if (settings.updates == 0) return place_views(views, settings);
  std::vector<std::uint64_t> fingerprints;
  fingerprints.reserve(views.size());
  for (const View& view : views)
    fingerprints.push_back(fingerprint(view, tables.origin, tables.casters, settings.translucent));
  return state.keeper.place(views, fingerprints, tables.origin, settings, static_cast<std::uint32_t>(settings.updates));
}

std::uint32_t lights_without_map(const std::vector<PlacedView>& placed) {
  std::set<std::uint32_t> without;
  for (const auto& at : placed)
    if (!at.tile) without.insert(at.view.light);
  return static_cast<std::uint32_t>(without.size());
}

bool casts_local_shadow(const shading::GpuLight& light) {
  return (light.flags & shading::kLightCastsShadow) != 0 && !shading::is_directional(light);
}

}  // namespace

void State::prepare(gpu::Device& device, const upload::Tables& tables, const Viewer& viewer, const Settings& settings) {
  draws.clear();
  if (!settings.enabled) {
    *this = State();
    return;
  }
  const auto placed = place(*this, tables, viewer, settings);
  Plan plan = make_plan(placed, tables.lights, tables.origin, atlas_side(settings));
  const auto without = lights_without_map(placed);
  if (plan.views.empty()) *this = State();
  without_map = without;
  if (plan.views.empty()) return;
  views = std::move(plan.views);
  first_view = std::move(plan.first_view);
  draws = std::move(plan.draws);
  allocate(*this, device, atlas_side(settings), std::ranges::any_of(views, is_translucent));
}

std::string State::note() const {
  if (without_map == 0) return {};
  return fmt::format(
      "{} lights cast no shadow: local_shadows.atlas has no room for their maps, or local_shadows.updates no time",
      without_map);
}

std::vector<MapMemory> State::memory() const {
  return {{"local_shadows.atlas", atlas.bytes()}, {"local_translucency.atlas", translucency.bytes()}};
}

passes::MapDemand demand(const upload::Tables& tables, const Settings& settings) {
  const bool any =
      settings.enabled && !tables.casters.casters.empty() && std::ranges::any_of(tables.lights, casts_local_shadow);
  const bool translucent = settings.translucent && upload::has_translucent(tables.casters);
  const std::uint64_t texel = kDepthBytes + (translucent ? kTranslucencyBytes : 0);
  return {"local_shadows.atlas", static_cast<int>(atlas_side(settings)), any ? texel : 0};
}

}  // namespace velarium::local_shadows
