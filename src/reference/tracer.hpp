#pragma once

// The whole picture: all pixels, all paths, on all threads.

#include "image/image.hpp"
#include "reference/film.hpp"
#include "scene/snapshot.hpp"

#include "shading/host.hpp"

#include <velarium/settings.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace velarium::reference {

struct Progress {
  double share = 0.0;      // of the work, as far as that is known
  double elapsed_s = 0.0;  // since tracing began
};

// One picture to be made. What it refers to must outlive the call.
struct Job {
  const scene::Scene& scene;
  const scene::SceneSnapshot& snapshot;
  scene::CameraInstance camera;
  std::vector<shading::GpuLight> lights;           // relative to the eye
  std::span<const glm::vec4> clip_records;         // upload::ClipVolumeTable, of the volumes that they end at
  std::span<const scene::Image> projectors;        // squares that GpuLight::projector_layer counts from 1; sRGB
  const image::FloatImage* environment = nullptr;  // null: none
  std::span<const glm::vec2> energy;               // EnergyTable, for the settings' model
  std::uint32_t energy_size = 0;
  std::uint32_t width = 0, height = 0;
  bool background = true;  // the environment is seen behind the scene
  bool opaque_background = true;
  const Settings& settings;
  // Called on the calling thread, before the first path and then some times a second; false: stop, and return what
  // there is.
  std::function<bool(const Progress&)> on_progress;
};

struct Result {
  Film film;
  bool finished = false;  // not stopped by on_progress
  double seconds = 0.0;   // spent on paths
  std::uint32_t threads = 0;
  std::uint64_t paths = 0;
  std::vector<std::string> notes;  // what a user should hear of, one sentence each
};

// Throws Error(temporary) where memory runs out.
[[nodiscard]] Result trace(const Job& job);

}  // namespace velarium::reference
