#include "api/view.hpp"

#include "bake/sky.hpp"
#include "bake/studio.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::api {
namespace {

constexpr const char* kStudio = "studio";
constexpr const char* kSky = "sky";      // a clear evening
constexpr const char* kWhite = "white";  // radiance 1 from everywhere: a furnace
constexpr const char* kNone = "none";

glm::vec3 to_vec3(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
}

// As conventions.md says: azimuth from +Z towards +X.
glm::vec3 direction_to(const Sun& sun) {
  const float azimuth = glm::radians(sun.azimuth_deg), elevation = glm::radians(sun.elevation_deg);
  const float across = std::cos(elevation);
  return {across * std::sin(azimuth), std::sin(elevation), across * std::cos(azimuth)};
}

scene::LightInstance light_of(const Sun& sun) {
  const glm::vec3 to_sun = direction_to(sun);
  const float azimuth = glm::radians(sun.azimuth_deg);
  return {.light = {.name = "sun",
                    .kind = scene::LightKind::directional,
                    .intensity = sun.illuminance_lux,
                    .angular_radius = glm::radians(sun.angular_radius_deg)},
          .direction = -to_sun,
          .right = {std::cos(azimuth), 0.0f, -std::sin(azimuth)}};
}

image::FloatImage white_environment() {
  return {.width = 2, .height = 1, .rgba = std::vector<float>(8, 1.0f)};
}

}  // namespace

std::string environment_choice(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                               const RenderRequest& request, std::vector<std::string>& notes) {
  if (!request.environment.empty()) return request.environment;
  if (!scene.environment.empty()) return scene.environment;
  if (snapshot.lights.empty() && !request.sun) return kStudio;
  notes.emplace_back(snapshot.lights.empty()
                         ? "the sun shines alone, as the environment is off; --env sky adds a sky"
                         : "the scene brings its own lights, so the environment is off; --env studio turns one on");
  return kNone;
}

void set_lights(const RenderRequest& request, scene::SceneSnapshot& snapshot) {
  if (!request.settings.lighting.punctual) snapshot.lights.clear();
  if (request.sun) snapshot.lights.push_back(light_of(*request.sun));
}

std::optional<image::FloatImage> environment_pixels(const std::string& name) {
  if (name == kNone) return std::nullopt;
  if (name == kStudio) return bake::studio_environment();
  if (name == kSky) return bake::sky_environment();
  if (name == kWhite) return white_environment();
  return image::load_radiance(name);
}

scene::CameraInstance camera_of(const scene::SceneSnapshot& snapshot, const RenderRequest& request) {
  if (request.look_at) {
    const auto& view = *request.look_at;
    return scene::look_at_camera(to_vec3(view.eye), to_vec3(view.target), to_vec3(view.up),
                                 glm::radians(view.vertical_fov_deg));
  }
  const float aspect = static_cast<float>(request.width) / static_cast<float>(std::max(request.height, 1u));
  return scene::choose_camera(snapshot, request.camera, aspect);
}

}  // namespace velarium::api
