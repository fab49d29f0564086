#pragma once

#include "frame/constants.hpp"
#include "frame/frame.hpp"
#include "scene/snapshot.hpp"

namespace velarium::frame {

// One picture to be made.
struct Job {
  const upload::GpuScene& scene;
  const scene::SceneSnapshot& snapshot;
  scene::CameraInstance camera;
  const bake::Environment* environment = nullptr;  // null: none
  const RenderRequest& request;
};

// Makes pictures: frames of a job, averaged, then displayed. Keeps maps and images between jobs.
class Renderer {
 public:
  explicit Renderer(gpu::GpuContext& tools);

  // Throws as check_request(), and Error(usage) for the name of an image to dump that no frame makes, listing those
  // there are.
  [[nodiscard]] RenderResult render(const Job& job);

 private:
  void run_frames(const Job& job, const FrameInputs& inputs, RenderReport& report);
  void read_picture(const Job& job, RenderResult& result);
  void fit_sum(std::uint32_t width, std::uint32_t height);

  gpu::GpuContext& tools_;
  graph::Executor executor_;
  Constants constants_;
  State state_;
  gpu::Image sum_;
};

}  // namespace velarium::frame
