#include "scene/gltf_parts.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace velarium::scene::gltf {

namespace {

constexpr float kAnyPositive = std::numeric_limits<float>::max();
constexpr float kWidestFov = 179.0f / 180.0f * std::numbers::pi_v<float>;

float positive(const Value& value) {
  const float number = value.number();
  if (!(number > 0.0f)) value.fail(fmt::format("is {}, must be more than 0", number));
  return number;
}

void read_perspective(const Value& value, Camera& camera) {
  camera.kind = Camera::Kind::perspective;
  const Value fov = value.require("yfov");
  camera.vertical_fov = positive(fov);
  if (camera.vertical_fov > kWidestFov) {
    fov.warn("is pi radians or nearly so, which no flat picture holds; 179 degrees are used");
    camera.vertical_fov = kWidestFov;
  }
  if (const Value aspect = value["aspectRatio"]) camera.aspect = positive(aspect);
  camera.z_near = positive(value.require("znear"));
  if (const Value far = value["zfar"]) camera.z_far = positive(far);
}

float half_size(const Value& value) {
  const float number = value.number();
  if (number == 0.0f) value.fail("must not be 0");
  if (number < 0.0f) value.warn("is negative; its absolute value is used");
  return std::abs(number);
}

void read_orthographic(const Value& value, Camera& camera) {
  camera.kind = Camera::Kind::orthographic;
  camera.half_size = {half_size(value.require("xmag")), half_size(value.require("ymag"))};
  const Value near = value.require("znear");
  camera.z_near = near.number();
  if (camera.z_near < 0.0f) near.fail(fmt::format("is {}, must be at least 0", camera.z_near));
  camera.z_far = positive(value.require("zfar"));
}

Camera read_camera(const Value& value) {
  Camera camera;
  camera.name = value["name"].text_or("");
  const Value perspective = value["perspective"], orthographic = value["orthographic"];
  const std::string_view type = value.require("type").text();
  if (type != "perspective" && type != "orthographic") {
    value["type"].fail(fmt::format("is '{}', must be perspective or orthographic", type));
  }
  if (perspective && orthographic) value.fail("has both perspective and orthographic; remove one");
  const Value lens = value.require(type);
  if (perspective) read_perspective(lens, camera);
  if (orthographic) read_orthographic(lens, camera);
  if (!(camera.z_far > camera.z_near)) lens.fail("zfar must be more than znear");
  return camera;
}

LightKind read_light_kind(const Value& value) {
  const std::string_view type = value.text();
  if (type == "directional") return LightKind::directional;
  if (type == "point") return LightKind::point;
  if (type == "spot") return LightKind::spot;
  value.fail(fmt::format("is '{}', must be directional, point or spot", type));
}

void read_cones(const Value& spot, Light& light) {
  const Value inner = spot["innerConeAngle"], outer = spot["outerConeAngle"];
  light.inner_cone = inner.number_or(light.inner_cone);
  light.outer_cone = outer.number_or(light.outer_cone);
  if (light.inner_cone < 0.0f) inner.fail("must be at least 0");
  constexpr float kWidest = std::numbers::pi_v<float> / 2.0f;
  if (light.outer_cone > kWidest) outer.fail("must be at most pi/2 radians");
  if (!(light.inner_cone < light.outer_cone)) (outer ? outer : inner).fail("outerConeAngle must exceed innerConeAngle");
}

Light read_light(const Value& value) {
  Light light;
  light.name = value["name"].text_or("");
  light.kind = read_light_kind(value.require("type"));
  light.color = value["color"].clamped_vector_or(light.color, 0.0f, kAnyPositive);
  light.intensity = value["intensity"].clamped_or(light.intensity, 0.0f, kAnyPositive);
  if (const Value range = value["range"]) light.range = positive(range);
  light.radius = value.extra("radius").value_or(light.radius);
  if (light.kind == LightKind::spot) read_cones(value.require("spot"), light);
  return light;
}

}  // namespace

void read_cameras(Context& context) {
  for (const Value& value : context.root["cameras"].elements()) context.scene.cameras.push_back(read_camera(value));
}

void read_lights_punctual(Context& context, const Value& extension) {
  for (const Value& value : extension.require("lights").elements()) context.scene.lights.push_back(read_light(value));
}

void read_node_light(Context& context, const Value& extension, Node& node) {
  const auto count = static_cast<std::uint32_t>(context.scene.lights.size());
  node.light = static_cast<std::int32_t>(extension.require("light").reference(count, "lights"));
}

}  // namespace velarium::scene::gltf
