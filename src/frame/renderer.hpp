#pragma once

#include "frame/constants.hpp"
#include "frame/frame.hpp"
#include "scene/snapshot.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace velarium::frame {

// The picture before one of a sequence.
struct JobBefore {
  const scene::SceneSnapshot& snapshot;
  scene::CameraInstance camera;
  std::uint64_t key = 0;  // its Job::key
};

// One picture to be made.
struct Job {
  const upload::GpuScene& scene;
  const scene::SceneSnapshot& snapshot;
  scene::CameraInstance camera;
  const bake::Environment* environment = nullptr;  // null: none
  const RenderRequest& request;
  std::optional<JobBefore> before = std::nullopt;  // none: the picture stands alone
  // A number that no picture of other content has: scene, time, camera, settings. 0: none is known.
  std::uint64_t key = 0;
};

// What frames are made of.
struct FrameRecipe {
  std::function<graph::GraphImage(graph::Graph&, const FrameInputs&)> add = add_frame;
  // Does any technique that these settings ask for look back to the frame before?
  std::function<bool(const Settings&)> looks_back = [](const Settings&) { return false; };
};

// Makes pictures: frames of a job, averaged, then displayed. Keeps maps and images between jobs.
//
// The pixels of a picture depend on its job alone. Where techniques look back, on the job before as well: the renderer
// draws one frame of that first, to warm up, unless it is the picture that it has made last.
class Renderer {
 public:
  explicit Renderer(gpu::GpuContext& tools, FrameRecipe recipe = {});

  // Throws as check_request(), and Error(usage) for the name of an image to dump that no frame makes, listing those
  // there are.
  [[nodiscard]] RenderResult render(const Job& job);

 private:
  // A snapshot seen by a camera, on the device.
  struct Shot {
    upload::Tables tables;
    upload::View view;
  };
  [[nodiscard]] Shot shoot(const Job& job, const scene::SceneSnapshot& snapshot, const scene::CameraInstance& camera);
  [[nodiscard]] FrameInputs inputs_of(const Job& job, const Shot& shot, const Shot& before, const Settings& settings);
  void warm_up(const Job& job, const Shot& before);
  void run_frames(const Job& job, const FrameInputs& inputs, RenderReport& report);
  void run_frame(const FrameInputs& inputs, Sync sync);
  void read_picture(const Job& job, RenderResult& result);
  void fit_sum(std::uint32_t width, std::uint32_t height);

  gpu::GpuContext& tools_;
  FrameRecipe recipe_;
  graph::Executor executor_;
  Constants constants_;
  State state_;
  gpu::Image sum_;
  std::uint64_t last_key_ = 0;  // of the picture that history is of
};

}  // namespace velarium::frame
