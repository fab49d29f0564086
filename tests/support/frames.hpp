#pragma once

// Frames below the library's interface: built-in scenes on a device, and cameras for them.

#include "frame/renderer.hpp"

#include <memory>
#include <string>

namespace velarium::test {

// One validated device for all tests of a program that work on frames themselves.
[[nodiscard]] gpu::GpuContext& gpu_context();

// A scene at rest, on that device.
struct StillScene {
  explicit StillScene(const std::string& name);  // "builtin:NAME"
  std::unique_ptr<scene::Scene> scene;
  scene::SceneSnapshot snapshot;
  std::unique_ptr<upload::GpuScene> gpu;
};

// Square pictures of 90 degrees along an axis of the world; up: unit, at right angles to it.
[[nodiscard]] scene::CameraInstance cube_camera(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& up);

}  // namespace velarium::test
