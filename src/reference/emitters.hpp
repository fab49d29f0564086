#pragma once

// Triangles that give light of their own, as light sources to aim at.

#include "reference/distribution.hpp"
#include "reference/materials.hpp"
#include "reference/objects.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace velarium::reference {

class Emitters {
 public:
  struct Sample {
    SurfacePoint point;
    bool front;          // the side that faces the receiver
    float pdf_m2;        // of the point, over area
    glm::vec3 radiance;  // towards the receiver, its opacity counted, nits
  };

  // Both must outlive this.
  Emitters(const std::vector<Object>& objects, const Materials& materials);

  [[nodiscard]] bool empty() const { return choice_.empty(); }
  // Roughly what a plane at `position` that faces them all receives, lux: the weight of this kind of light beside
  // others.
  [[nodiscard]] float irradiance_at(const glm::vec3& position) const;
  // A triangle by its power, a point on it evenly. Nothing where the point does not shine towards `position`.
  // Precondition: not empty().
  [[nodiscard]] std::optional<Sample> sample(const glm::vec3& position, float u_triangle, const glm::vec2& u) const;
  // Density of sample() for a point of this triangle, over area; 0 for triangles that do not shine.
  [[nodiscard]] float pdf_m2(std::uint32_t object, std::uint32_t triangle, float area_m2) const;

 private:
  struct Triangle {
    std::uint32_t object, index;
  };
  static constexpr std::uint32_t kDark = ~0u;

  [[nodiscard]] static std::vector<float> powers(const std::vector<Object>& objects, const Materials& materials,
                                                 std::vector<Triangle>& triangles, std::vector<std::uint32_t>& first);
  void find_extent();

  const std::vector<Object>& objects_;
  const Materials& materials_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> first_;  // of each object in triangles_, or kDark
  Distribution1d choice_;
  glm::vec3 center_{0.0f};
  float radius_m_ = 0.0f;
};

}  // namespace velarium::reference
