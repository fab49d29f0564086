#pragma once

// Where the maps of the sun lie: which part of the view each serves, and the box of the world that it sees. All in
// double precision, so that texels stay where they are in the world wherever the viewer stands.

#include "passes/sun_map.hpp"

#include <vector>

namespace velarium::sun_shadows {

// A view as the fit needs it.
struct View {
  glm::dvec3 eye{0.0}, forward{0.0, 0.0, -1.0};  // world space, metres; unit
  glm::dvec2 half{1.0};                          // perspective: tangents of half the field of view; else metres
  bool perspective = true;
};

struct Sphere {
  glm::dvec3 center{0.0};
  double radius = 0.0;
};

struct DepthRange {
  double near = 0.0, far = 0.0;  // view depth, metres
};

// Borders of `count` slices of the range, count + 1 of them: between equal ratios (lambda 1) and equal lengths (0)
// [Zhang et al. 2006, "Parallel-Split Shadow Maps"]. Precondition: 0 < near < far.
[[nodiscard]] std::vector<double> split_depths(const DepthRange& range, int count, double lambda);

// The smallest sphere around a slice of the view whose centre lies on its axis.
[[nodiscard]] Sphere slice_sphere(const View& view, const DepthRange& slice);

// The depths of the view at which a sphere may be seen, in steps of a quarter octave, so that a moving viewer keeps the
// same slices for a while. `longest`: an end to the far side, metres; 0: none. The near side is 0 where it is nearer
// than kDepthRatio of the far one.
inline constexpr double kDepthRatio = 0.01;
[[nodiscard]] DepthRange visible_depths(const View& view, const Sphere& scene, double longest);

using Map = passes::SunMap;

// What limits a map besides the sphere that it serves.
struct MapLimits {
  passes::LightBox scene;  // the bounds of all casters
  double margin = 0.0;     // metres: the widest filter
  // Metres towards the sun from which casters are drawn as they stand; others are clamped.
  double blocker_distance = 0.0;
  int size = 1;  // texels
};

// A map of the sphere's surroundings, its corner on whole texels.
[[nodiscard]] Map fit_map(const glm::dmat3& axes, const Sphere& sphere, const MapLimits& limits);

// Does a sphere and what filters need around it still lie inside a map that was fitted to another?
[[nodiscard]] bool covers(const Map& map, const Sphere& sphere, double margin);

// Is map i of a view that moves drawn for this picture, if nothing else asks for it? The first two always are; of the
// others, which change less the farther they are, one a picture at most [Crytek 2011].
[[nodiscard]] bool is_due(std::size_t map, std::uint64_t picture);

}  // namespace velarium::sun_shadows
