#include "scene/moment.hpp"

#include <velarium/error.hpp>

#include "core/assert.hpp"
#include "scene/moment_choice.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::scene {
namespace {

// With reversed depth in floats, precision hardly depends on the near plane: it only has to lie before all that is
// seen. This one serves cameras that name none above zero.
constexpr float kDefaultNear = 0.01f;

// The fitted view: the three-quarter angle of product photography, with a lens of 50 mm on a 36 x 24 mm frame held
// upright (39.6 degrees along the 36 mm side), long enough not to distort.
constexpr float kFittedFov = 0.6911f;
constexpr float kFittedAzimuth = glm::radians(30.0f);  // from +Z, the front of a glTF model, towards +X
constexpr float kFittedElevation = glm::radians(20.0f);
constexpr float kFittedMargin = 1.08f;  // 4 % of the picture's size on each side

glm::mat3 view_axes(const glm::vec3& back, const glm::vec3& up) {
  const glm::vec3 right = glm::normalize(glm::cross(up, back));
  return {right, glm::cross(back, right), back};
}

CameraInstance placed(const glm::vec3& eye, const glm::mat3& axes, float vertical_fov, float z_near, const char* name) {
  CameraInstance out;
  out.camera.name = name;
  out.camera.vertical_fov = vertical_fov;
  out.camera.z_near = z_near;
  out.world_from_view = {glm::vec4(axes[0], 0), glm::vec4(axes[1], 0), glm::vec4(axes[2], 0), glm::vec4(eye, 1)};
  return out;
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// A box that a camera can be fitted to: never empty, and of some extent.
Aabb solid(const Aabb& bounds) {
  if (bounds.empty() || !is_finite(bounds.min) || !is_finite(bounds.max)) return {glm::vec3(-1.0f), glm::vec3(1.0f)};
  const glm::vec3 center = 0.5f * (bounds.min + bounds.max);
  const float size = glm::length(bounds.max - bounds.min);
  // A point far from the origin still needs a box that its floats can tell from it.
  const float least = std::max(1e-3f * size, 1e-4f * std::max(1.0f, glm::length(center)));
  const glm::vec3 half = glm::max(0.5f * (bounds.max - bounds.min), glm::vec3(least));
  return {center - half, center + half};
}

// Along one axis of the picture: how far right (or up) and how far back the camera stands.
struct Stand {
  float across = 0.0f, back = 0.0f;
};

// A point (x, z) of view space is inside where |x - across| <= slope (back - z). The two planes that touch the points
// meet in the nearest stand that sees them all, and it sees them centred.
class Fit {
 public:
  explicit Fit(float slope) : slope_(slope) {}
  void add(float x, float z) {
    high_ = std::max(high_, slope_ * z + x);
    low_ = std::max(low_, slope_ * z - x);
  }
  [[nodiscard]] Stand stand() const { return {0.5f * (high_ - low_), 0.5f * (high_ + low_) / slope_}; }

 private:
  float slope_;
  float high_ = -std::numeric_limits<float>::infinity(), low_ = -std::numeric_limits<float>::infinity();
};

// Half heights and widths grow on one axis, so that a picture of another shape than the camera's shows all that the
// camera frames, and nothing is stretched. Returns the factors for x and y.
glm::vec2 widening(float camera_aspect, float picture_aspect) {
  return picture_aspect >= camera_aspect ? glm::vec2(picture_aspect / camera_aspect, 1.0f)
                                         : glm::vec2(1.0f, camera_aspect / picture_aspect);
}

glm::mat4 perspective(const Camera& camera, float aspect) {
  const float camera_aspect = camera.aspect.value_or(aspect);
  const glm::vec2 wider = widening(camera_aspect, aspect);
  const float half_height = std::tan(0.5f * camera.vertical_fov);
  const float z_near = camera.z_near > 0.0f ? camera.z_near : kDefaultNear;
  glm::mat4 m(0.0f);
  m[0][0] = 1.0f / (half_height * camera_aspect * wider.x);
  m[1][1] = -1.0f / (half_height * wider.y);
  m[2][3] = -1.0f;
  m[3][2] = z_near;  // depth = near / distance
  return m;
}

glm::mat4 orthographic(const Camera& camera, float aspect) {
  const glm::vec2 half = camera.half_size * widening(camera.half_size.x / camera.half_size.y, aspect);
  const float depth = camera.z_far - camera.z_near;
  VEL_ASSERT(std::isfinite(depth) && depth > 0.0f);
  glm::mat4 m(0.0f);
  m[0][0] = 1.0f / half.x;
  m[1][1] = -1.0f / half.y;
  m[2][2] = 1.0f / depth;
  m[3][2] = camera.z_far / depth;
  m[3][3] = 1.0f;
  return m;
}

}  // namespace

CameraInstance look_at_camera(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up,
                              float vertical_fov_rad) {
  const float distance = glm::length(eye - target);
  if (!(distance > 0.0f)) throw Error(ErrorCode::usage, "look-at camera: eye and target coincide; move one of them");
  const glm::vec3 back = (eye - target) / distance;
  // Below 1e-4 of the length of `up`, rounding would decide which way is up.
  if (!(glm::length(glm::cross(up, back)) > 1e-4f * glm::length(up))) {
    throw Error(ErrorCode::usage, "look-at camera: up is parallel to the view; choose another up");
  }
  return placed(eye, view_axes(back, up), vertical_fov_rad, std::min(0.1f, 0.01f * distance), "look-at");
}

CameraInstance fitted_camera(const Aabb& bounds, float aspect) {
  const Aabb box = solid(bounds);
  const glm::vec3 center = 0.5f * (box.min + box.max);
  const glm::vec3 back(std::sin(kFittedAzimuth) * std::cos(kFittedElevation), std::sin(kFittedElevation),
                       std::cos(kFittedAzimuth) * std::cos(kFittedElevation));
  const glm::mat3 world_from_view = view_axes(back, {0, 1, 0});
  const float slope = std::tan(0.5f * kFittedFov) / kFittedMargin;
  Fit horizontal(slope * aspect), vertical(slope);
  float front = -std::numeric_limits<float>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 world((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                          (corner & 4) ? box.max.z : box.min.z);
    const glm::vec3 view = glm::transpose(world_from_view) * (world - center);
    horizontal.add(view.x, view.z);
    vertical.add(view.y, view.z);
    front = std::max(front, view.z);
  }
  const Stand x = horizontal.stand(), y = vertical.stand();
  const float z = std::max(x.back, y.back);
  const glm::vec3 eye = center + world_from_view * glm::vec3(x.across, y.across, z);
  const float z_near = 0.5f * (z - front);  // half way to the nearest corner of the box
  return placed(eye, world_from_view, kFittedFov, z_near, "auto");
}

CameraInstance choose_camera(const Moment& moment, const std::string& choice, float aspect) {
  if (choice == "auto" || (choice.empty() && moment.cameras.empty())) return fitted_camera(moment.bounds, aspect);
  if (choice.empty()) return moment.cameras.front();
  std::vector<std::string> names;
  for (const CameraInstance& instance : moment.cameras) names.push_back(instance.camera.name);
  const auto found = find_choice(names, choice);
  if (!found) throw Error(ErrorCode::usage, unknown_choice("camera", names, choice, "auto"));
  return moment.cameras[*found];
}

glm::mat4 clip_from_view(const Camera& camera, float aspect) {
  VEL_ASSERT(aspect > 0.0f);
  return camera.kind == Camera::Kind::perspective ? perspective(camera, aspect) : orthographic(camera, aspect);
}

}  // namespace velarium::scene
