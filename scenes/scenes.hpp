#pragma once

// The scenes that need no file, one .cpp each.

#include "scene/scene.hpp"

namespace velarium::scene {

// Metals and dielectrics from rough to smooth, on a grey ground. No light: made for an image of the surroundings.
[[nodiscard]] Scene spheres_scene();

// White spheres of every roughness, metallic and not, in front of nothing. No light: under surroundings of constant
// radiance a shading model that neither makes nor loses energy renders them invisible.
[[nodiscard]] Scene furnace_scene();

// The Cornell box, ten times its measured size.
[[nodiscard]] Scene cornell_scene();

// A Roman courtyard at evening: columns, arches, painted walls, a pool, awnings, and the light of 24 torches and of the
// environment "sky". Cameras "entrance", "pool" and "walk".
[[nodiscard]] Scene atrium_scene();

}  // namespace velarium::scene
