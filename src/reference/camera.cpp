#include "reference/camera.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace velarium::reference {

Camera::Camera(const scene::CameraInstance& camera, std::uint32_t width, std::uint32_t height)
    : axes_(glm::mat4(camera.world_from_view)),
      projection_(scene::clip_from_view(camera.camera, static_cast<float>(width) / static_cast<float>(height))),
      ndc_per_pixel_(2.0f / glm::vec2(width, height)),
      perspective_(projection_[3][3] == 0.0f) {
  // Where depth is 1 and 0.
  const float a = projection_[2][2], b = projection_[3][2];
  z_near_ = perspective_ ? b / (1.0f + a) : (b - 1.0f) / a;
  z_far_ = a == 0.0f ? std::numeric_limits<float>::infinity() : b / a;
  pixel_size_ = std::abs(ndc_per_pixel_.y / projection_[1][1]);
}

Ray Camera::ray(const glm::vec2& place) const {
  const glm::vec2 ndc = place * ndc_per_pixel_ - 1.0f;
  const glm::mat4& p = projection_;
  Ray ray;
  ray.skip_back_faces = true;
  if (!perspective_) {
    const glm::vec2 at = (ndc - glm::vec2(p[3])) / glm::vec2(p[0][0], p[1][1]);
    ray.origin = axes_ * glm::vec3(at, 0.0f);
    ray.direction = -axes_[2];
    ray.from = z_near_;
    ray.to = z_far_;
    ray.cone_width_m = pixel_size_;
    return ray;
  }
  const glm::vec3 view((ndc.x + p[2][0]) / p[0][0], (ndc.y + p[2][1]) / p[1][1], -1.0f);
  const float length = glm::length(view);
  ray.direction = axes_ * (view / length);
  ray.from = z_near_ * length;
  ray.to = z_far_ * length;
  ray.cone_spread = pixel_size_ / length;
  return ray;
}

}  // namespace velarium::reference
