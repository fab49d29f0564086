#pragma once

#include <velarium/engine.hpp>
#include <velarium/picture.hpp>
#include <velarium/scene.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace velarium {

// How far a reference picture is.
struct ReferenceProgress {
  double share = 0;      // of the work, 0..1, as far as limits of time and noise let it be known
  double elapsed_s = 0;  // since the first path
};

struct ReferenceRequest {
  // The view, as Engine::render() takes it. What speaks of devices, frames and dumps has no meaning here: paths a pixel
  // and what else only the path tracer asks are in view.settings.reference, the seed is view.settings.frame.seed.
  RenderRequest view;
  // Called on the calling thread, before the first path and then some times a second. False: stop, and return what
  // there is.
  std::function<bool(const ReferenceProgress&)> on_progress;
};

struct ReferenceReport {
  bool finished = false;       // not stopped by on_progress
  double seconds = 0;          // spent on paths: neither on the scene's hierarchy nor on files
  double prepare_seconds = 0;  // before the first path
  std::uint64_t paths = 0;
  std::uint32_t samples = 0;  // fewest paths of a pixel
  std::uint32_t threads = 0;
  double relative_error = 0;       // of the picture, estimated; docs/reference.md
  std::vector<std::string> notes;  // decisions a user should hear of, one sentence each
};

struct ReferenceResult {
  // `layers`: variance (of the mean), albedo, normal, depth, direct, indirect. `attributes` tell how it was made.
  Picture picture;
  ReferenceReport report;
};

// The picture that light itself would make of the scene, by tracing paths on the CPU: no device is needed. The same
// request gives the same bytes on one machine, whatever the number of threads, unless a limit of time ends it.
// Throws as Engine::render() does for the scene and the view.
[[nodiscard]] ReferenceResult render_reference(const Scene& scene, const ReferenceRequest& request);

}  // namespace velarium
