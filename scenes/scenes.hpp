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

// Shadows: on a plane stand blocks, a ball, a fence of thin bars, a pierced screen (cut out by its texture), and, where
// `sheet` says so, a sheet hangs that half of the light passes. One light of the kind, and nothing else, lights them.
// radius: metres of the bulb, or radians of the sun's disc; 0: light from one point, or one direction.
[[nodiscard]] Scene boxes_scene(LightKind light, float radius, bool sheet);

inline constexpr std::uint32_t kTorches = 24;

// A Roman courtyard at evening: columns, arches, painted walls, a pool, awnings, and the light of 24 torches and of the
// environment "sky". Cameras "entrance", "pool" and "walk". Another number of lights has the power of the torches in
// all: points and spots spread over the court, each reaching as far as it lights as brightly as a torch at its end.
// sun: the evening is earlier: a low sun shines through the awnings, torches are as large as their flames, and a
// lantern throws a pattern.
[[nodiscard]] Scene atrium_scene(std::uint32_t lights, bool sun);

// Copies of one gilded knot, 1152 triangles each, arranged as the seeds of a sunflower. The disc keeps its size, so
// that more copies are smaller ones and cover about the same pixels.
[[nodiscard]] Scene knots_scene(std::uint32_t instances);

// Mountains around a lake in the evening sun, with about so many triangles of land, in 256 patches. Finer meshes show
// finer shapes of the same land.
[[nodiscard]] Scene terrain_scene(std::uint32_t triangles);

}  // namespace velarium::scene
