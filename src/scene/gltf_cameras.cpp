#include "scene/gltf_parts.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

namespace velarium::scene::gltf {

namespace {

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
    fov.repair("is pi radians or nearly so, which no flat picture holds; 179 degrees are used");
    camera.vertical_fov = kWidestFov;
  }
  if (const Value aspect = value["aspectRatio"]) camera.aspect = positive(aspect);
  camera.z_near = positive(value.require("znear"));
  if (const Value far = value["zfar"]) camera.z_far = positive(far);
}

float half_size(const Value& value) {
  const float number = value.number();
  if (number == 0.0f) value.fail("must not be 0");
  if (number < 0.0f) value.repair("is negative; its absolute value is used");
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

}  // namespace

void read_cameras(Context& context) {
  for (const Value& value : context.root["cameras"].elements()) context.scene.cameras.push_back(read_camera(value));
}

}  // namespace velarium::scene::gltf
