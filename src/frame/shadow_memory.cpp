#include "frame/shadow_memory.hpp"

#include "passes/far_shadows/far_shadows.hpp"
#include "passes/local_shadows/local_shadows.hpp"
#include "passes/sun_shadows/sun_shadows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace velarium::frame {
namespace {

constexpr std::uint64_t kMaskTexel = 4;  // R32F (passes/sun_mask)

// Maps that share a side.
struct Maps {
  const char* option;                                       // that names the side
  int Settings::sun_shadows_settings::*sun_side = nullptr;  // null: the atlas
  int side = 0;                                             // texels
  std::uint64_t texel_bytes = 0;                            // of all of them together
  [[nodiscard]] std::uint64_t bytes() const {
    return static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side) * texel_bytes;
  }
};

// In the order in which equals are halved.
std::array<Maps, 3> all_maps(const Settings& settings, const ShadowNeeds& needs) {
  using Sun = Settings::sun_shadows_settings;
  const auto& sun = settings.sun_shadows;
  const bool is_static = needs.far == FarSun::static_map;
  const std::uint64_t sun_texel = sun_shadows::kDepthBytes + (needs.sun_veils ? sun_shadows::kVeilBytes : 0);
  const std::uint64_t atlas_texel = local_shadows::kDepthBytes + (needs.atlas_veils ? local_shadows::kVeilBytes : 0);
  return {
      {{is_static ? "sun_shadows.static_size" : "sun_shadows.far_size", is_static ? &Sun::static_size : &Sun::far_size,
        is_static ? sun.static_size : sun.far_size, far_shadows::texel_bytes(needs.far)},
       {"local_shadows.atlas", nullptr, static_cast<int>(local_shadows::atlas_side(settings.local_shadows)),
        needs.atlas ? atlas_texel : 0},
       {"sun_shadows.size", &Sun::size, sun.size, needs.sun_maps * sun_texel}}};
}

void set_side(Settings& settings, const Maps& maps, int side) {
  if (maps.sun_side != nullptr)
    settings.sun_shadows.*maps.sun_side = side;
  else
    settings.local_shadows.atlas = side;
}

std::string note_of(const Settings& wanted, const Settings& fitted, const ShadowNeeds& needs) {
  const auto before = all_maps(wanted, needs), after = all_maps(fitted, needs);
  std::string changes;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (after[i].side != before[i].side)
      changes += fmt::format("{}{} is {} instead of {}", changes.empty() ? "" : ", ", after[i].option, after[i].side,
                             before[i].side);
  return changes.empty() ? changes
                         : fmt::format("{}: shadows.memory={} allows no more", changes, wanted.shadows.memory);
}

std::uint64_t budget_of(const Settings& settings) {
  return static_cast<std::uint64_t>(settings.shadows.memory) << 20;
}

}  // namespace

std::uint64_t shadow_bytes(const Settings& settings, const ShadowNeeds& needs) {
  std::uint64_t bytes = needs.mask_bytes;
  for (const Maps& maps : all_maps(settings, needs)) bytes += maps.bytes();
  return bytes;
}

FittedShadows fit_to_budget(const Settings& wanted, const ShadowNeeds& needs) {
  FittedShadows fitted{wanted, {}};
  const auto savable = [](const Maps& maps) { return maps.side > kLeastMapSide ? maps.bytes() : 0; };
  while (shadow_bytes(fitted.settings, needs) > budget_of(wanted)) {
    const auto maps = all_maps(fitted.settings, needs);
    const auto& most = *std::max_element(maps.begin(), maps.end(),
                                         [&](const Maps& a, const Maps& b) { return savable(a) < savable(b); });
    if (savable(most) == 0) break;
    set_side(fitted.settings, most, std::max(most.side / 2, kLeastMapSide));
  }
  fitted.note = note_of(wanted, fitted.settings, needs);
  if (const auto bytes = shadow_bytes(fitted.settings, needs); bytes > budget_of(wanted))
    fitted.note += fmt::format("{}shadows take {} MiB, more than shadows.memory={}, in a picture as large as this",
                               fitted.note.empty() ? "" : "; ", bytes >> 20, wanted.shadows.memory);
  return fitted;
}

ShadowNeeds shadow_needs(const upload::SceneTables& scene, const upload::ViewMatrices& view, const Settings& settings,
                         std::uint64_t pixels) {
  const auto sun = sun_shadows::demand(scene, view, settings.sun_shadows);
  const auto& lights = scene.host_lights;
  const bool lamps = settings.local_shadows.enabled && !scene.casters.casters.empty() &&
                     std::any_of(lights.begin(), lights.end(), [](const shading::GpuLight& light) {
                       return (light.flags & shading::kLightCastsShadow) != 0 && !shading::is_directional(light);
                     });
  const bool translucent = upload::has_translucent(scene.casters);
  // Far maps that are kept over several pictures stay where a picture does not need them.
  const bool far = !sun.whole || settings.sun_shadows.update == MapUpdate::staggered;
  return {.sun_maps = sun.maps,
          .sun_veils = translucent && settings.sun_shadows.translucent,
          .far = far ? far_shadows::possible_kind(settings.sun_shadows.far, scene.casters) : FarSun::off,
          .atlas = lamps,
          .atlas_veils = translucent && settings.local_shadows.translucent,
          .mask_bytes = sun.maps > 0 ? kMaskTexel * pixels : 0};
}

}  // namespace velarium::frame
