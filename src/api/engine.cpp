#include <velarium/engine.hpp>

#include <velarium/error.hpp>

#include "bake/sky.hpp"
#include "bake/studio.hpp"
#include "frame/renderer.hpp"
#include "image/image.hpp"
#include "scene/moment.hpp"

#include <glm/trigonometric.hpp>

namespace velarium {
namespace {

constexpr const char* kStudio = "studio";
constexpr const char* kSky = "sky";      // a clear evening
constexpr const char* kWhite = "white";  // radiance 1 from everywhere: a furnace
constexpr const char* kNone = "none";

glm::vec3 to_vec3(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
}

image::FloatImage white_environment() {
  return {.width = 2, .height = 1, .rgba = std::vector<float>(8, 1.0f)};
}

// The environment that a picture gets: what was asked for, else the studio where the scene brings no light.
std::string environment_choice(const scene::Scene& scene, const scene::Moment& moment, const RenderRequest& request,
                               std::vector<std::string>& notes) {
  if (!request.environment.empty()) return request.environment;
  if (!scene.environment.empty()) return scene.environment;
  if (moment.lights.empty()) return kStudio;
  notes.emplace_back("the scene brings its own lights, so the environment is off; --env studio turns one on");
  return kNone;
}

scene::CameraInstance camera_of(const scene::Moment& moment, const RenderRequest& request) {
  if (request.look_at) {
    const auto& view = *request.look_at;
    return scene::look_at_camera(to_vec3(view.eye), to_vec3(view.target), to_vec3(view.up),
                                 glm::radians(view.vertical_fov_deg));
  }
  const float aspect = static_cast<float>(request.width) / static_cast<float>(std::max(request.height, 1u));
  return scene::choose_camera(moment, request.camera, aspect);
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
  gpu::Toolbox tools;
  frame::Renderer renderer;
  // The last scene and environment stay on the device: programs move cameras more often than they change scenes.
  std::optional<Scene> scene;  // keeps the tables alive that gpu_scene refers to
  std::unique_ptr<upload::GpuScene> gpu_scene;
  std::string environment_name;
  std::optional<bake::Environment> environment;

  const upload::GpuScene& upload(const Scene& wanted, const scene::Moment& moment) {
    if (!scene || &scene->tables() != &wanted.tables()) {
      gpu_scene.reset();
      scene = wanted;
      gpu_scene = std::make_unique<upload::GpuScene>(device, scene->tables());
    }
    gpu_scene->set_deformed(moment);
    return *gpu_scene;
  }

  const bake::Environment* load_environment(const std::string& name) {
    if (name == kNone) return nullptr;
    if (environment && environment_name == name) return &*environment;
    const auto pixels = name == kStudio  ? bake::studio_environment()
                        : name == kSky   ? bake::sky_environment()
                        : name == kWhite ? white_environment()
                                         : image::load_radiance(name);
    environment = bake::bake_environment(tools, pixels);
    environment_name = name;
    return &*environment;
  }
};

Engine::Engine(const EngineOptions& options) : state_(std::make_unique<State>(options)) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

RenderResult Engine::render(const Scene& scene, const RenderRequest& request) {
  std::vector<std::string> notes;
  const auto moment = scene::moment_at(scene.tables(), request.time_s, request.animation);
  const auto* environment = state_->load_environment(environment_choice(scene.tables(), moment, request, notes));
  const auto& gpu_scene = state_->upload(scene, moment);
  auto result = state_->renderer.render({gpu_scene, moment, camera_of(moment, request), environment, request});
  result.report.notes = std::move(notes);
  return result;
}

}  // namespace velarium
