#include "statistical/tracer_scene.hpp"

#include "bake/environment_brdf.hpp"

#include <glm/trigonometric.hpp>

#include <cmath>
#include <numeric>

namespace velarium::statistical {
namespace {

constexpr std::uint32_t kEnergySize = 16;

std::vector<glm::vec2> energy() {
  static const auto kTable = bake::environment_brdf(kEnergySize, shading::kModelGltf);
  return kTable;
}

}  // namespace

scene::Material matt(float albedo, float emission) {
  scene::Material m;
  m.base_color = {albedo, albedo, albedo, 1.0f};
  m.metallic = 0.0f;
  m.ior = 1.0f;
  m.emissive = glm::vec3(emission);
  return m;
}

double Traced::radiance() const {
  const auto rgba = film.beauty();
  double sum = 0.0;
  for (std::size_t i = 1; i < rgba.size(); i += 4) sum += static_cast<double>(rgba[i]);
  return sum / static_cast<double>(rgba.size() / 4);
}

double Traced::standard_error() const {
  const auto rgb = film.variance();
  double sum = 0.0;
  for (std::size_t i = 1; i < rgb.size(); i += 3) sum += static_cast<double>(rgb[i]);
  return std::sqrt(sum) / static_cast<double>(rgb.size() / 3);
}

Traced Tracing::run() const {
  const scene::SceneSnapshot snapshot = scene::snapshot_at(scene, 0.0f, "");
  const auto table = energy();
  auto result = reference::trace({.scene = scene,
                                  .snapshot = snapshot,
                                  .camera = camera,
                                  .lights = lights,
                                  .projectors = projectors,
                                  .environment = environment ? &*environment : nullptr,
                                  .energy = table,
                                  .energy_size = kEnergySize,
                                  .width = size,
                                  .height = size,
                                  .settings = settings,
                                  .on_progress = on_progress});
  return {std::move(result.film), std::move(result.notes), result.finished};
}

scene::CameraInstance point_below(float height) {
  auto camera = scene::look_at_camera({0.0f, height, 0.0f}, glm::vec3(0.0f), {0.0f, 0.0f, -1.0f}, 1.0f);
  camera.camera.kind = scene::Camera::Kind::orthographic;
  camera.camera.half_size = glm::vec2(1e-4f);
  camera.camera.z_near = 0.0f;
  camera.camera.z_far = 2.0f * height;
  return camera;
}

scene::CameraInstance all_around() {
  return scene::look_at_camera(glm::vec3(0.0f), {0.0f, 0.0f, -1.0f}, {0.0f, 1.0f, 0.0f}, glm::radians(120.0f));
}

scene::Primitive square(float half_side, float height, bool looks_up) {
  const float s = half_side, y = height;
  if (looks_up) return scene::quad({glm::vec3(-s, y, s), {s, y, s}, {s, y, -s}, {-s, y, -s}});
  return scene::quad({glm::vec3(-s, y, -s), {s, y, -s}, {s, y, s}, {-s, y, s}});
}

image::FloatImage constant_environment(float radiance) {
  return {.width = 8, .height = 4, .rgba = std::vector<float>(4 * 8 * 4, radiance)};
}

}  // namespace velarium::statistical
