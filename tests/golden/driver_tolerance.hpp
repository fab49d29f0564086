#pragma once

#include "support/metric.hpp"

#include <string_view>

namespace velarium::test {

// What a picture of the table may differ by on drivers other than lavapipe, which drew the accepted ones. Vulkan leaves
// sub-pixel positions and filters to the driver; SwiftShader, which has the fewest sub-pixel bits that it allows, was
// measured: each number is the smallest round one above it.
struct OtherDrivers {
  std::string_view picture;  // "", the last row: every other one
  Tolerance tolerance;
  std::string_view why;
};

inline constexpr OtherDrivers kOtherDrivers[] = {
    {"atrium",
     {.max_error = 16, .share = 0.01},
     "lavapipe filters 8-bit textures in 8 bits, which shows in the normals of the water and of distant walls (half "
     "of the difference goes when it is told not to), and edges are everywhere"},
    {"atrium_torches", {.max_error = 16, .share = 0.01}, "as atrium"},
    {"atrium_pool", {.max_error = 16, .share = 0.01}, "as atrium"},
    {"bumpy_metal",
     {.max_error = 16, .share = 0.02},
     "fine normals under one light: lavapipe filters them in 8 bits, as in atrium"},
    {"sun_far",
     {.max_error = 16, .share = 0.006},
     "casters snap to 1/16 of a texel of a coarse map, which a blurred one shows as another shade all over its "
     "penumbrae"},
    {"wrap_modes",
     {.max_error = 4, .share = 0.015},
     "where a texture repeats there is an edge along a whole row of pixels, and it moves by one of four samples"},
    {"",
     {.max_error = 4, .share = 0.006},
     "vertices snap to 1/16 of a pixel instead of 1/256: along edges, one of four samples sees another surface"}};

// The tolerance of a picture on the device of this name. `usual`: on lavapipe.
[[nodiscard]] inline Tolerance tolerance_on(std::string_view device, std::string_view picture, Tolerance usual) {
  if (device.starts_with("llvmpipe")) return usual;
  for (const OtherDrivers& row : kOtherDrivers)
    if (row.picture.empty() || row.picture == picture) return row.tolerance;
  return usual;
}

}  // namespace velarium::test
