#include "scene/description_parts.hpp"
#include "scene/description_place.hpp"

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace velarium::scene::description {
namespace {

scene::LightKind kind_of(velarium::LightKind kind) {
  switch (kind) {
    case velarium::LightKind::directional:
      return LightKind::directional;
    case velarium::LightKind::point:
      return LightKind::point;
    case velarium::LightKind::spot:
      return LightKind::spot;
  }
  return LightKind::point;
}

// Lights shine along -Z of their node, and the picture that one throws stands along its +Y.
glm::quat rotation_of(const Place& at, const LightDescription& light) {
  at.finite("direction", light.direction);
  at.finite("up", light.up);
  const glm::vec3 direction(light.direction[0], light.direction[1], light.direction[2]);
  if (!std::isnormal(glm::dot(direction, direction))) at.fail("direction", "has no length, or one that is no number");
  const glm::vec3 unit = glm::normalize(direction);
  glm::vec3 up(light.up[0], light.up[1], light.up[2]);
  constexpr float kParallel = 1e-4f;  // sine of an angle within which rounding would decide
  if (!(glm::length(glm::cross(up, unit)) > kParallel * glm::length(up)))
    up = std::abs(unit.y) > 0.9f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  const glm::quat q = glm::quatLookAt(unit, up);
  return unit_quaternion({q.x, q.y, q.z, q.w});
}

void set_cones(const Place& at, const LightDescription& from, Light& light) {
  if (!(from.outer_cone_deg > 0.0f && from.outer_cone_deg <= 90.0f))
    at.fail("outer_cone_deg", fmt::format("is {}, must be more than 0 and at most 90", from.outer_cone_deg));
  at.not_negative("inner_cone_deg", from.inner_cone_deg);
  if (!(from.inner_cone_deg < from.outer_cone_deg))
    at.fail("inner_cone_deg", fmt::format("is {}, must be less than outer_cone_deg", from.inner_cone_deg));
  light.inner_cone = glm::radians(from.inner_cone_deg);
  light.outer_cone = glm::radians(from.outer_cone_deg);
}

void set_projector(const Place& at, const LightDescription& from, const Scene& scene, Light& light) {
  Projector& projector = light.projector;
  projector.image = at.reference("projected_image", from.projected_image, scene.images.size(), "images");
  if (!projector.present()) return;
  if (light.kind != LightKind::spot) at.fail("projected_image", "belongs to a light that is no spot");
  at.not_negative("projected_fov_deg", from.projected_fov_deg);
  at.between("projected_soft_edge", from.projected_soft_edge, 0.0f, 1.0f);
  const float field_deg = from.projected_fov_deg > 0.0f ? from.projected_fov_deg : 2.0f * from.outer_cone_deg;
  at.within("projected_fov_deg", field_deg, 0.0f, 180.0f);
  projector.field_of_view = glm::radians(field_deg);
  projector.soft_edge = from.projected_soft_edge;
}

// What belongs to lights, and what to suns.
void set_size(const Place& at, const LightDescription& from, Light& light) {
  at.not_negative("range_m", from.range_m);
  at.not_negative("radius_m", from.radius_m);
  at.not_negative("angular_radius_deg", from.angular_radius_deg);
  if (light.kind == LightKind::directional) {
    if (!(from.angular_radius_deg < 90.0f))
      at.fail("angular_radius_deg", fmt::format("is {}, must be less than 90", from.angular_radius_deg));
    if (from.radius_m > 0.0f) at.fail("radius_m", "belongs to a directional light, which has an angular_radius_deg");
    if (from.falloff == LightFalloff::bulb)
      at.fail("falloff", "belongs to a directional light, which does not fall off");
    light.angular_radius = glm::radians(from.angular_radius_deg);
    return;
  }
  if (from.angular_radius_deg > 0.0f) at.fail("angular_radius_deg", "belongs to a light, which has a radius_m");
  light.range = from.range_m;
  light.radius = from.radius_m;
  if (from.falloff != LightFalloff::bulb) return;
  if (from.radius_m == 0.0f) at.fail("falloff", "is that of a bulb, which needs a radius_m");
  light.falloff = Falloff::bulb;
}

Light light_of(const Place& at, const LightDescription& from, const Scene& scene) {
  at.not_negative("color", from.color);
  at.not_negative("intensity", from.intensity);
  Light light;
  light.name = from.name;
  light.kind = kind_of(from.kind);
  light.color = {from.color[0], from.color[1], from.color[2]};
  light.intensity = from.intensity;
  light.casts_shadow = from.casts_shadow;
  set_size(at, from, light);
  if (light.kind == LightKind::spot) set_cones(at, from, light);
  set_projector(at, from, scene, light);
  return light;
}

}  // namespace

void add_lights(const SceneDescription& description, Scene& scene) {
  for (const LightDescription& light : description.lights) {
    const Place at("lights", scene.lights.size());
    at.finite("position", light.position);
    Node node;
    node.name = light.name;
    node.parent = at.reference("parent", light.parent, description.nodes.size(), "nodes");
    node.translation = {light.position[0], light.position[1], light.position[2]};
    node.rotation = rotation_of(at, light);
    node.light = static_cast<std::int32_t>(scene.lights.size());
    scene.lights.push_back(light_of(at, light, scene));
    add_node(scene, std::move(node));
  }
}

}  // namespace velarium::scene::description
