#pragma once

#include "image/image.hpp"

namespace velarium::bake {

// A clear evening sky as an equirectangular picture, 1024 x 512, from code: deep blue overhead, gold around a sun that
// has just set at the far left of a camera that looks along -z, lilac opposite, thin high clouds, and below the
// horizon the light that a warm stone ground gives back. No sun disc, so nothing in it asks for hard shadows.
// Radiance is about 0.45 on average in red, and at most 8.
[[nodiscard]] image::FloatImage sky_environment();

}  // namespace velarium::bake
