#include <velarium/engine.hpp>

#include <velarium/error.hpp>

#include "api/view.hpp"
#include "frame/renderer.hpp"
#include "scene/snapshot.hpp"

#include <algorithm>
#include <bit>

namespace velarium {
namespace {

// Drivers that compile a pipeline for what it meets (llvmpipe) look at formats and at whether sizes are powers of two,
// so a rehearsal's picture is like the real one in both.
std::uint32_t rehearsal_size(std::uint32_t size) {
  return std::has_single_bit(size) ? 16 : 24;
}

// The same pipelines for a few pixels. The first frame of a picture writes, further ones add: two show both.
RenderRequest rehearsal_of(const RenderRequest& request) {
  RenderRequest small = request;
  small.width = rehearsal_size(request.width);
  small.height = rehearsal_size(request.height);
  small.look_at = LookAt{};
  small.settings.frame.spp = std::min(request.settings.frame.spp, 2);
  small.dumps.clear();
  small.on_frame = nullptr;
  return small;
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
  const gpu::Instance instance(false);
  std::vector<DeviceInfo> result;
  for (const auto device : instance.physical_devices())
    result.push_back(gpu::describe_device(device, static_cast<std::uint32_t>(result.size())));
  return result;
}

struct Engine::State {
  explicit State(const EngineOptions& options)
      : device(options.device, options.validation), tools(device), renderer(tools) {}

  gpu::Device device;
  gpu::GpuContext tools;
  frame::Renderer renderer;
  // The last scene and environment stay on the device: programs move cameras more often than they change scenes.
  std::optional<Scene> scene;  // keeps the tables alive that gpu_scene refers to
  std::unique_ptr<upload::GpuScene> gpu_scene;
  std::string environment_name;
  std::optional<bake::Environment> environment;

  const upload::GpuScene& upload(const Scene& wanted) {
    if (!scene || &scene->tables() != &wanted.tables()) {
      gpu_scene.reset();
      scene = wanted;
      gpu_scene = std::make_unique<upload::GpuScene>(device, scene->tables());
    }
    return *gpu_scene;
  }

  const bake::Environment* load_environment(const std::string& name) {
    if (environment && environment_name == name) return &*environment;
    const auto pixels = api::environment_pixels(name);
    if (!pixels) return nullptr;
    environment = bake::bake_environment(tools, *pixels);
    environment_name = name;
    return &*environment;
  }
};

Engine::Engine(const EngineOptions& options) : state_(std::make_unique<State>(options)) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

void Engine::prepare(const RenderRequest& request) {
  if (request.environment.empty()) return;  // the scene will decide
  const bake::Environment* environment = state_->load_environment(request.environment);
  const RenderRequest small = rehearsal_of(request);
  const scene::Scene nothing;
  const scene::SceneSnapshot snapshot;
  const upload::GpuScene gpu_scene(state_->device, nothing);
  static_cast<void>(
      state_->renderer.render({gpu_scene, snapshot, api::camera_of(snapshot, small), environment, small}));
}

RenderResult Engine::render(const Scene& scene, const RenderRequest& request) {
  std::vector<std::string> notes;
  auto snapshot = scene::snapshot_at(scene.tables(), request.time_s, request.animation);
  const auto* environment = state_->load_environment(api::environment_choice(scene.tables(), snapshot, request, notes));
  api::set_lights(request, snapshot);
  const auto& gpu_scene = state_->upload(scene);
  auto result = state_->renderer.render({gpu_scene, snapshot, api::camera_of(snapshot, request), environment, request});
  result.report.notes.insert(result.report.notes.begin(), notes.begin(), notes.end());
  return result;
}

}  // namespace velarium
