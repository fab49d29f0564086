#pragma once

#include <array>
#include <cstdint>

namespace velarium::image {

// A colour for an error from 0 (black) to 1 (pale yellow), over violet, red and orange: display values. Lightness
// grows evenly, so that of two errors the larger is the lighter, in grey and to colour-blind eyes as well.
[[nodiscard]] std::array<std::uint8_t, 3> error_color(float error);

}  // namespace velarium::image
