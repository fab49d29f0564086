#pragma once

#include "bake/environment.hpp"
#include "frame/frame.hpp"
#include "frame/shadow_memory.hpp"
#include "graph/executor.hpp"
#include "scene/moment.hpp"
#include "upload/scene_tables.hpp"

#include <velarium/engine.hpp>

#include <functional>
#include <string>
#include <vector>

namespace velarium::frame {

// One picture to be made.
struct Job {
  const upload::GpuScene& scene;
  const scene::Moment& moment;
  scene::CameraInstance camera;
  const bake::Environment* environment = nullptr;  // null: none
  const RenderRequest& request;
};

// Makes pictures: frames of a job, averaged, then displayed. Keeps tables and images between jobs.
class Renderer {
 public:
  explicit Renderer(gpu::Toolbox& tools);

  // Throws as check_request(), and Error(usage) for the name of an image to dump that no frame makes, listing those
  // there are.
  [[nodiscard]] RenderResult render(const Job& job);

 private:
  void run_frames(const Job& job, const FrameInputs& inputs, upload::FrameUniforms uniforms,
                  const upload::ViewMatrices& view, RenderReport& report);
  // The settings, with maps as large as shadows.memory allows. What an earlier picture left and this one has no use for
  // is given back.
  [[nodiscard]] FittedShadows fit_shadows(const upload::SceneTables& scene, const upload::ViewMatrices& view,
                                          const RenderRequest& request);
  void fit_sun_maps(upload::SceneTables& scene, const upload::ViewMatrices& view,
                    const Settings::sun_shadows_settings& settings);
  [[nodiscard]] std::vector<MapMemory> shadow_maps();
  void read_picture(const Job& job, RenderResult& result);
  [[nodiscard]] const gpu::Image& brdf_table(ShadingModel model);

  gpu::Toolbox& tools_;
  graph::Executor executor_;
  gpu::Image normal_lengths_, black_, black_cube_, no_map_;
  gpu::Image brdf_tables_[2];  // by shading::environment_model(), made when first asked for
  sun_shadows::Maps sun_maps_;
  far_shadows::Map far_map_;
  gpu::Image sum_;
  local_shadows::Maps local_shadows_;
};

}  // namespace velarium::frame
