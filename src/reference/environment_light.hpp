#pragma once

#include "image/image.hpp"
#include "reference/distribution.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace velarium::reference {

// Light from far away: an equirectangular picture as docs/conventions.md defines it, read between the centres of its
// pixels linearly, around the seam, and clamped at the poles, as the renderer reads it. Unlike the renderer's half
// floats, nothing is rounded or clamped.
//
// A direction is chosen through the pixel it falls into. Pixels are chosen by solid angle times luminance, where the
// luminance is the root of the mean square over the pixel of what is read there: that minimises the variance of an
// estimate whose density is constant over the pixel, and is above 0 wherever any light is read.
class EnvironmentLight {
 public:
  struct Sample {
    glm::vec3 wi;        // unit
    glm::vec3 radiance;  // nits
    float pdf_sr;        // > 0
  };

  // The picture's values are finite and not negative, and there is at least one pixel. rotation_deg: counter-clockwise
  // about +Y; intensity: multiplies the picture.
  EnvironmentLight(image::FloatImage lat_long, float rotation_deg, float intensity);

  // No direction sends any light: there is nothing to sample.
  [[nodiscard]] bool dark() const { return pixels_.empty(); }

  // Directions are unit vectors in the axes of the world. Radiance in nits.
  [[nodiscard]] glm::vec3 radiance(const glm::vec3& direction_ws) const;
  // u in [0, 1)^2. Precondition: not dark().
  [[nodiscard]] Sample sample(const glm::vec2& u) const;
  // Density with which sample() returns wi, per steradian; 0 where dark().
  [[nodiscard]] float pdf_sr(const glm::vec3& wi) const;

 private:
  [[nodiscard]] glm::vec3 to_environment(const glm::vec3& d) const;
  [[nodiscard]] glm::vec3 to_world(const glm::vec3& d) const;
  [[nodiscard]] float pdf_sr_of(float pdf_square, std::uint32_t row) const;
  [[nodiscard]] glm::vec3 read(const glm::vec2& uv) const;

  image::FloatImage image_;
  float cos_rotation_, sin_rotation_, intensity_;
  std::vector<double> row_cosines_;  // of the polar angles between rows, height + 1
  Distribution2d pixels_;
};

}  // namespace velarium::reference
