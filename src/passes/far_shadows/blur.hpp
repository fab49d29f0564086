#pragma once

namespace velarium::far_shadows {

// Texels beside the middle that a blur of this deviation, in texels, reads.
[[nodiscard]] int blur_radius(double deviation);

}  // namespace velarium::far_shadows
