#pragma once

#include "reference/geometry.hpp"
#include "scene/snapshot.hpp"

namespace velarium::reference {

// Rays of a picture, from the matrices that the renderer projects with: equal cameras show equal edges.
class Camera {
 public:
  Camera(const scene::CameraInstance& camera, std::uint32_t width, std::uint32_t height);

  // Through a place of the picture in pixels, from the near plane on. The origin of the world is at the eye.
  [[nodiscard]] Ray ray(const glm::vec2& place) const;
  // Metres along the view axis.
  [[nodiscard]] float view_depth(const glm::vec3& position_ws) const { return -glm::dot(axes_[2], position_ws); }

 private:
  glm::mat3 axes_;        // world from view
  glm::mat4 projection_;  // clip from view
  glm::vec2 ndc_per_pixel_;
  bool perspective_;
  float z_near_, z_far_;  // metres; z_far_ infinite for perspective views
  float pixel_size_;      // height of a pixel at one metre (perspective), or anywhere, metres
};

}  // namespace velarium::reference
