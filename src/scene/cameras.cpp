#include "scene/snapshot.hpp"

#include <velarium/error.hpp>

#include "core/assert.hpp"
#include "scene/choice.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace velarium::scene {
namespace {

// With reversed depth in floats, precision hardly depends on the near plane: it only has to lie before all that is
// seen. This one serves cameras that name none above zero.
constexpr float kDefaultNear = 0.01f;
// Of a look-at camera, as a share of the distance to its target, which may stand far behind a tiny scene.
constexpr float kLookAtNear = 1e-5f;

// The fitted view: the three-quarter angle of product photography, with a lens of 50 mm on a 36 x 24 mm frame held
// upright (39.6 degrees along the 36 mm side), long enough not to distort.
constexpr float kFittedFov = 0.6911f;
constexpr float kFittedAzimuth = glm::radians(30.0f);  // from +Z, the front of a glTF model, towards +X
constexpr float kFittedElevation = glm::radians(20.0f);
constexpr float kFittedMargin = 1.08f;  // 4 % of the picture's size on each side

// Directions are floats, as in every matrix of the device.
glm::mat3 view_axes(const glm::vec3& back, const glm::vec3& up) {
  const glm::vec3 right = glm::normalize(glm::cross(up, back));
  return {right, glm::cross(back, right), back};
}

CameraInstance placed(const glm::dvec3& eye, const glm::mat3& axes, float vertical_fov, float z_near,
                      const char* name) {
  CameraInstance out;
  out.camera.name = name;
  out.camera.vertical_fov = vertical_fov;
  out.camera.z_near = z_near;
  out.world_from_view = {glm::dvec4(axes[0], 0), glm::dvec4(axes[1], 0), glm::dvec4(axes[2], 0), glm::dvec4(eye, 1)};
  return out;
}

// Coordinates whose squares, and those of sums of a few, still are floats.
bool is_measurable(const glm::dvec3& v) {
  constexpr double kFarthest = 1e15;  // metres
  return std::abs(v.x) < kFarthest && std::abs(v.y) < kFarthest && std::abs(v.z) < kFarthest;
}

// A box that a camera can be fitted to: of some extent on each axis, and not too small for doubles to tell its corners
// apart so far from the origin.
WorldAabb solid(const WorldAabb& bounds) {
  constexpr double kThin = 1e-5, kTellApart = 1e-14;  // of the size; of the distance to the origin
  constexpr double kHalfOfNothing = 0.5;              // metres: what a single point is shown in
  if (bounds.empty() || !is_measurable(bounds.min) || !is_measurable(bounds.max)) {
    return {glm::dvec3(-kHalfOfNothing), glm::dvec3(kHalfOfNothing)};
  }
  const glm::dvec3 center = 0.5 * (bounds.min + bounds.max);
  const double size = glm::length(bounds.max - bounds.min);
  const double least = std::max(size > 0.0 ? kThin * size : kHalfOfNothing, kTellApart * glm::length(center));
  const glm::dvec3 half = glm::max(0.5 * (bounds.max - bounds.min), glm::dvec3(least));
  return {center - half, center + half};
}

// The corners of a box along one axis of the picture: x across, z towards the camera.
using Outline = std::array<glm::vec2, 8>;

// How far back a camera must stand to see all corners within |x - across| <= slope * (back - z): where the two planes
// that touch them from both sides meet.
float distance_to_see(const Outline& corners, float slope) {
  float right = -std::numeric_limits<float>::infinity(), left = right;
  for (const glm::vec2& corner : corners) {
    right = std::max(right, slope * corner.y + corner.x);
    left = std::max(left, slope * corner.y - corner.x);
  }
  return 0.5f * (right + left) / slope;
}

// Where across to stand at distance `back` so that the outermost corners are as far from the middle of the picture:
// moving right moves every corner left, so halving the interval finds the balance.
float centred(const Outline& corners, float back) {
  constexpr int kRounds = 24;  // the bits of a float
  const auto [first, last] = std::minmax_element(corners.begin(), corners.end(),
                                                 [](const glm::vec2& a, const glm::vec2& b) { return a.x < b.x; });
  float low = first->x, high = last->x;
  for (int round = 0; round < kRounds; ++round) {
    const float across = 0.5f * (low + high);
    float left = 0.0f, right = 0.0f;
    for (const glm::vec2& corner : corners) {
      left = std::min(left, (corner.x - across) / (back - corner.y));
      right = std::max(right, (corner.x - across) / (back - corner.y));
    }
    (right > -left ? low : high) = across;
  }
  return 0.5f * (low + high);
}

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
  // Depth: near / distance without an end; with one, near (far - distance) / (distance (far - near)).
  const bool endless = std::isinf(camera.z_far);
  glm::mat4 m(0.0f);
  m[0][0] = 1.0f / (half_height * camera_aspect * wider.x);
  m[1][1] = -1.0f / (half_height * wider.y);
  m[2][2] = endless ? 0.0f : z_near / (camera.z_far - z_near);
  m[2][3] = -1.0f;
  m[3][2] = endless ? z_near : camera.z_far * m[2][2];
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

CameraInstance look_at_camera(const glm::dvec3& eye, const glm::dvec3& target, const glm::vec3& up,
                              float vertical_fov_rad) {
  const glm::vec3 way(eye - target);
  const float distance = glm::length(way);
  if (!(distance > 0.0f)) throw Error(ErrorCode::usage, "look-at camera: eye and target coincide; move one of them");
  const glm::vec3 back = way / distance;
  // Below 1e-4 of the length of `up`, rounding would decide which way is up.
  if (!(glm::length(glm::cross(up, back)) > 1e-4f * glm::length(up))) {
    throw Error(ErrorCode::usage, "look-at camera: up is parallel to the view; choose another up");
  }
  return placed(eye, view_axes(back, up), vertical_fov_rad, kLookAtNear * distance, "look-at");
}

CameraInstance fitted_camera(const WorldAabb& bounds, float aspect) {
  const WorldAabb box = solid(bounds);
  const glm::dvec3 center = 0.5 * (box.min + box.max);
  const glm::vec3 back(std::sin(kFittedAzimuth) * std::cos(kFittedElevation), std::sin(kFittedElevation),
                       std::cos(kFittedAzimuth) * std::cos(kFittedElevation));
  const glm::mat3 world_from_view = view_axes(back, {0, 1, 0});
  const float slope = std::tan(0.5f * kFittedFov) / kFittedMargin;
  Outline horizontal, vertical;
  float front = -std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 corner((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                            (i & 4) ? box.max.z : box.min.z);
    const glm::vec3 view = glm::transpose(world_from_view) * glm::vec3(corner - center);
    horizontal[i] = {view.x, view.z};
    vertical[i] = {view.y, view.z};
    front = std::max(front, view.z);
  }
  const float back_off = std::max(distance_to_see(horizontal, slope * aspect), distance_to_see(vertical, slope));
  const glm::vec3 stand(centred(horizontal, back_off), centred(vertical, back_off), back_off);
  const glm::dvec3 eye = center + glm::dvec3(world_from_view * stand);
  const float z_near = 0.5f * (back_off - front);  // half way to the nearest corner of the box
  return placed(eye, world_from_view, kFittedFov, z_near, "auto");
}

CameraInstance choose_camera(const SceneSnapshot& snapshot, const std::string& choice, float aspect) {
  if (choice == "auto" || (choice.empty() && snapshot.cameras.empty())) return fitted_camera(snapshot.bounds, aspect);
  if (choice.empty()) return snapshot.cameras.front();
  std::vector<std::string> names;
  for (const CameraInstance& instance : snapshot.cameras) names.push_back(instance.camera.name);
  const auto found = find_choice(names, choice);
  if (!found) throw Error(ErrorCode::usage, unknown_choice("camera", names, choice, "auto"));
  return snapshot.cameras[*found];
}

glm::mat4 clip_from_view(const Camera& camera, float aspect) {
  VEL_ASSERT(aspect > 0.0f);
  return camera.kind == Camera::Kind::perspective ? perspective(camera, aspect) : orthographic(camera, aspect);
}

}  // namespace velarium::scene
