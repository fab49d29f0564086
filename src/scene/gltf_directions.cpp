#include "scene/gltf_directions.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace velarium::scene::gltf {

namespace {

// Squared lengths this near 1 are exact to a float; normalising them would change bits for nothing.
constexpr float kUnitTolerance = 1e-5f;
// Eight normalised bits leave a length within 0.9 %, its square within 1.8 %; more is the file's doing.
constexpr float kWarnTolerance = 0.02f;
constexpr float kSmallestSquare = 1e-24f;  // well above where float squares lose precision

struct Findings {
  bool not_unit = false, zero = false;
};

// Returns false where `direction` has no direction.
bool make_unit(glm::vec3& direction, Findings& findings) {
  const float square = glm::dot(direction, direction);
  const float deviation = std::abs(square - 1.0f);
  if (deviation <= kUnitTolerance) return true;
  if (!(square > kSmallestSquare) || !std::isfinite(square)) {
    findings.zero = true;
    return false;
  }
  findings.not_unit |= deviation > kWarnTolerance;
  direction *= 1.0f / std::sqrt(square);
  return true;
}

void report(const Value& at, const Findings& findings) {
  if (findings.not_unit) at.repair("has directions that are not of unit length; they were normalised");
  if (findings.zero) at.repair("has directions of no length; others stand in for them");
}

glm::vec3 across(const glm::vec3& normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(axis - normal * glm::dot(axis, normal));
}

}  // namespace

void make_unit_normals(const Value& at, std::vector<glm::vec3>& normals) {
  Findings findings;
  for (glm::vec3& normal : normals) {
    if (!make_unit(normal, findings)) normal = glm::vec3(0.0f);
  }
  report(at, findings);
}

void make_unit_tangents(const Value& at, const std::vector<glm::vec3>& normals, std::vector<glm::vec4>& tangents) {
  Findings findings;
  bool wrong_sign = false;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    glm::vec3 direction(tangents[i]);
    if (!make_unit(direction, findings)) direction = across(normals[i]);
    const float sign = tangents[i].w < 0.0f ? -1.0f : 1.0f;
    wrong_sign |= tangents[i].w != sign;
    tangents[i] = {direction, sign};
  }
  report(at, findings);
  if (wrong_sign) at.repair("has signs (w) that are neither 1 nor -1; the nearest was taken");
}

}  // namespace velarium::scene::gltf
