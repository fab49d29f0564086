#pragma once

#include "passes/environment/read.hpp"

#include <velarium/settings.hpp>

#include <glm/vec4.hpp>

#include <array>
#include <span>

namespace velarium::environment {

using Settings = velarium::Settings::environment_settings;

// Images as Reading has them.
struct Inputs {
  const gpu::Image* background = nullptr;
  const gpu::Image* lobes = nullptr;
  const gpu::Image* irradiance = nullptr;
  const gpu::Image* brdf_table = nullptr;
  std::span<const glm::vec4> sh;  // nine, or none where there is no environment
  bool shown = false;             // is it the background?
  glm::vec4 color{0.0f};          // of the background where it is not: linear, premultiplied by its coverage
  bool occlusion = true;          // baked occlusion textures darken it
};

[[nodiscard]] Reading add(graph::Graph& graph, const Inputs& in, const Settings& settings);

}  // namespace velarium::environment
