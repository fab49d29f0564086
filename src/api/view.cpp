#include "api/view.hpp"

#include "bake/sky.hpp"
#include "bake/studio.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>

namespace velarium::api {
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

}  // namespace

std::string environment_choice(const scene::Scene& scene, const scene::Moment& moment, const RenderRequest& request,
                               std::vector<std::string>& notes) {
  if (!request.environment.empty()) return request.environment;
  if (!scene.environment.empty()) return scene.environment;
  if (moment.lights.empty()) return kStudio;
  notes.emplace_back("the scene brings its own lights, so the environment is off; --env studio turns one on");
  return kNone;
}

std::optional<image::FloatImage> environment_pixels(const std::string& name) {
  if (name == kNone) return std::nullopt;
  if (name == kStudio) return bake::studio_environment();
  if (name == kSky) return bake::sky_environment();
  if (name == kWhite) return white_environment();
  return image::load_radiance(name);
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

}  // namespace velarium::api
