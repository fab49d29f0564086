#pragma once

#include <array>

namespace velarium {

// A perspective camera, given by where it stands and what is in the middle of its picture.
struct LookAt {
  std::array<float, 3> eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};  // metres, world space
  float vertical_fov_deg = 45.0f;
};

}  // namespace velarium
