#pragma once

// What the tests of the shading maths share.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <glm/vec3.hpp>

#include "shading/host.hpp"

namespace velarium::shading {

inline constexpr double kPiExact = 3.14159265358979323846;

inline double degrees(double radians) {
  return radians * 180.0 / kPiExact;
}
inline double radians(double degrees) {
  return degrees * kPiExact / 180.0;
}

// Reproducible on every machine: the standard's distributions are not.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  float uniform(float low = 0.0f, float high = 1.0f) {
    return low + (high - low) * static_cast<float>(engine_() >> 8) / 16777216.0f;
  }
  vec3 color() { return {uniform(), uniform(), uniform()}; }
  vec3 direction() {
    const float z = uniform(-1.0f, 1.0f), phi = uniform(0.0f, kTwoPi), r = std::sqrt(1.0f - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  vec3 hemisphere_direction() {
    const vec3 d = direction();
    return {d.x, d.y, std::abs(d.z)};
  }

 private:
  std::mt19937 engine_;
};

// What a UNORM8 target keeps of a value.
inline float unorm8(float v) {
  return std::floor(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f) / 255.0f;
}
inline vec3 unorm8(vec3 v) {
  return {unorm8(v.x), unorm8(v.y), unorm8(v.z)};
}
inline vec4 unorm8(vec4 v) {
  return {unorm8(v.x), unorm8(v.y), unorm8(v.z), unorm8(v.w)};
}
inline int code8(float stored) {
  return static_cast<int>(std::lround(stored * 255.0f));
}

// In double: the arc cosine of fp32 resolves no better than 0.02 degrees.
inline double angle_degrees(const vec3& a, const vec3& b) {
  const glm::dvec3 u{a}, v{b};
  return degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
}

// Of best-fit normals, in degrees: halfway between the axis and (127, 1, 1) two components are half an integer off.
inline constexpr double kWorstNormalError = 0.32;

// The best-fit length k of one direction, searched in double.
inline int best_fit_length(const vec3& direction) {
  const glm::dvec3 n = glm::dvec3(glm::abs(direction)) / static_cast<double>(max_component(glm::abs(direction)));
  double best = 2.0;
  int best_k = 0;
  for (int k = 127; k > 0; --k) {
    const glm::dvec3 q = glm::floor(n * static_cast<double>(k) + 0.5);
    const double sin2 = 1.0 - glm::dot(q, n) * glm::dot(q, n) / (glm::dot(q, q) * glm::dot(n, n));
    if (sin2 < best - 1e-13) {
      best = sin2;
      best_k = k;
    }
  }
  return best_k;
}

}  // namespace velarium::shading
