#include "core/jobs.hpp"
#include "scene/tangents.hpp"
#include "scenes/atrium_daylight.hpp"
#include "scenes/atrium_parts.hpp"
#include "scenes/scenes.hpp"

#include <glm/trigonometric.hpp>

namespace velarium::scene {
namespace {

void add_cameras(SceneBuilder& builder) {
  constexpr float kAspect = 16.0f / 9.0f;
  const auto add = [&](const char* name, float fov_deg, const glm::vec3& eye, const glm::vec3& target) {
    builder.place_camera(glm::radians(fov_deg), kAspect, eye, target, name);
  };
  add("entrance", 52.0f, {-3.1f, 1.75f, 8.6f}, {0.9f, 2.1f, -3.0f});
  add("pool", 42.0f, {2.9f, 1.35f, 6.0f}, {-1.2f, 1.05f, -2.0f});
  add("walk", 50.0f, {7.5f, 1.75f, 7.3f}, {7.0f, 1.9f, 0.0f});
}

void add_tangents(Scene& scene) {
  parallel_for(scene.primitives.size(), [&](std::size_t i) {
    Primitive& p = scene.primitives[i];
    if (scene.materials[static_cast<std::size_t>(p.material)].normal_texture.present()) make_tangents(p, 0);
  });
}

}  // namespace

Scene atrium_scene(std::uint32_t lights, bool sun) {
  SceneBuilder builder("atrium");
  atrium::add_materials(builder);
  atrium::add_columns(builder);
  atrium::add_arches(builder);
  atrium::add_walls(builder);
  atrium::add_roof(builder);
  atrium::add_floors(builder);
  atrium::add_vessels(builder);
  atrium::add_awnings(builder);
  const bool torches = lights == kTorches;
  atrium::add_torches(builder, torches, sun ? atrium::kFlameRadius : 0.0f);
  if (!torches) atrium::add_extra_lights(builder, lights);
  if (sun) atrium::add_beams(builder);
  add_cameras(builder);
  Scene scene = std::move(builder).take();
  atrium::measure_daylight(scene);
  add_tangents(scene);
  scene.environment = "sky";
  return scene;
}

}  // namespace velarium::scene
