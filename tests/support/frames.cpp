#include "support/frames.hpp"

#include "scene/builtin.hpp"
#include "support/device_choice.hpp"

#include <numbers>

namespace velarium::test {

gpu::GpuContext& gpu_context() {
  static gpu::Device device(device_choice(), true);
  static gpu::GpuContext context(device);
  return context;
}

StillScene::StillScene(const std::string& name)
    : scene(std::make_unique<scene::Scene>(scene::builtin_scene(name))),
      snapshot(scene::snapshot_at(*scene, 0.0f, {})),
      gpu(std::make_unique<upload::GpuScene>(gpu_context().device, *scene)) {}

scene::CameraInstance cube_camera(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& up) {
  return scene::look_at_camera(eye, eye + forward, up, 0.5f * std::numbers::pi_v<float>);
}

}  // namespace velarium::test
