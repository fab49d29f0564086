#pragma once

// How shadows.memory bounds the maps of a picture.

#include "upload/gpu_scene.hpp"
#include "upload/scene_tables.hpp"

#include <velarium/settings.hpp>

#include <cstdint>
#include <string>

namespace velarium::frame {

// Which maps a picture may have, whatever their size.
struct ShadowNeeds {
  std::uint32_t sun_maps = 0;
  bool sun_veils = false;
  FarSun far = FarSun::off;
  bool atlas = false, atlas_veils = false;
  std::uint64_t mask_bytes = 0;  // of the sun's mask, as large as the picture
};

// Maps are not made smaller than this to save memory, texels a side: six maps of the sun, a far one and an atlas, all
// with veils, then take less than the least that shadows.memory can be.
inline constexpr int kLeastMapSide = 256;

// Texels of all maps as the settings ask for them. Drivers may add to align them.
[[nodiscard]] std::uint64_t shadow_bytes(const Settings& settings, const ShadowNeeds& needs);

struct FittedShadows {
  Settings settings;  // but for the sides of maps as asked for
  std::string note;   // which sides are others, in a sentence; empty: none
};

// Maps are halved in width and height until all fit into shadows.memory together: at each step those that take the
// most; of equals, first the far map of the sun, then the atlas of lamps, then the near maps of the sun. Where all have
// kLeastMapSide and what is left is still too much, as the mask of a large picture may be, the note says so.
[[nodiscard]] FittedShadows fit_to_budget(const Settings& wanted, const ShadowNeeds& needs);

// Of a picture of so many pixels. Translucent casters and lamps that cast shadows count wherever they stand.
[[nodiscard]] ShadowNeeds shadow_needs(const upload::SceneTables& scene, const upload::ViewMatrices& view,
                                       const Settings& settings, std::uint64_t pixels);

}  // namespace velarium::frame
