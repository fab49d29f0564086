#pragma once

// Small scenes with a known answer, traced.

#include "reference/tracer.hpp"

#include "scenes/shapes.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace velarium::statistical {

// A Lambert surface: with an index of refraction of 1 nothing is reflected specularly.
[[nodiscard]] scene::Material matt(float albedo, float emission = 0.0f);

struct Traced {
  reference::Film film;
  std::vector<std::string> notes;
  bool finished = true;

  // Means over all pixels.
  [[nodiscard]] double radiance() const;        // green
  [[nodiscard]] double standard_error() const;  // of radiance(), from the film's own variances
};

struct Tracing {
  scene::Scene scene;
  scene::CameraInstance camera;
  std::vector<shading::GpuLight> lights = {};  // relative to the camera
  std::vector<scene::Image> projectors = {};   // GpuLight::projector_layer counts them from 1
  std::optional<image::FloatImage> environment = {};
  Settings settings = {};
  std::uint32_t size = 8;  // pixels a side
  std::function<bool(const reference::Progress&)> on_progress = {};

  [[nodiscard]] Traced run() const;
};

// Looks straight down from (0, height, 0) at a square of the plane y = 0 that is next to nothing.
[[nodiscard]] scene::CameraInstance point_below(float height);
// A wide view from the origin along -z.
[[nodiscard]] scene::CameraInstance all_around();

// A square in the plane y = height, looking up or down, centred above or below the origin.
[[nodiscard]] scene::Primitive square(float half_side, float height, bool looks_up);

[[nodiscard]] image::FloatImage constant_environment(float radiance);

}  // namespace velarium::statistical
