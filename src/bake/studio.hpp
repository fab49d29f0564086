#pragma once

#include "image/image.hpp"

namespace velarium::bake {

// A neutral photographic studio as an equirectangular picture, 1024 x 512, from code and not from a file. Dim grey
// surroundings, a large soft box overhead, the key light at the left front and a narrow rim light behind right of a
// camera that looks along -z, a weak fill card at its right, and a floor that gives some light back.
// Radiance is 0.6 on average and 20 at its peak: a white matt object is bright, and not burnt, at exposure 0.
[[nodiscard]] image::FloatImage studio_environment();

}  // namespace velarium::bake
