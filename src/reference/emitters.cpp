#include "reference/emitters.hpp"

#include "core/jobs.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace velarium::reference {
namespace {

// Where a triangle's emission is looked up for its mean: the centre, and half way from there to each corner. Each
// lookup reads the mip whose texels are as large as the triangle's quarters, so little escapes.
constexpr std::array<glm::vec2, 4> kPlaces{glm::vec2(1.0f / 3.0f), glm::vec2(2.0f / 3.0f, 1.0f / 6.0f),
                                           glm::vec2(1.0f / 6.0f, 2.0f / 3.0f), glm::vec2(1.0f / 6.0f)};

// Watts of light, but for the solid angle.
float power_of(const Object& object, std::uint32_t triangle, const Materials& materials) {
  glm::vec3 sum(0.0f);
  float area = 0.0f;
  for (const glm::vec2& place : kPlaces) {
    const SurfacePoint p = surface_point(object, triangle, place.x, place.y);
    area = p.area_m2;
    const Footprint footprint{0.5f * std::sqrt(p.area_m2), 0.5f};
    sum += materials.emission(p, footprint) * materials.transparency(p, footprint).opacity;
  }
  const float sides = materials.double_sided(object.material) ? 2.0f : 1.0f;
  const float power = shading::luminance(sum) / kPlaces.size() * area * sides;
  return power < std::numeric_limits<float>::max() ? std::max(power, 0.0f) : 0.0f;
}

}  // namespace

Emitters::Emitters(const std::vector<Object>& objects, const Materials& materials)
    : objects_(objects), materials_(materials), choice_(powers(objects, materials, triangles_, first_)) {
  find_extent();
}

std::vector<float> Emitters::powers(const std::vector<Object>& objects, const Materials& materials,
                                    std::vector<Triangle>& triangles, std::vector<std::uint32_t>& first) {
  first.assign(objects.size(), kDark);
  for (std::uint32_t i = 0; i < objects.size(); ++i) {
    if (!materials.may_emit(objects[i].material)) continue;
    first[i] = static_cast<std::uint32_t>(triangles.size());
    for (std::uint32_t t = 0; t < objects[i].triangle_count(); ++t) triangles.push_back({i, t});
  }
  constexpr std::size_t kRun = 1024;  // triangles that a job takes at a time
  std::vector<float> powers(triangles.size());
  parallel_for((triangles.size() + kRun - 1) / kRun, [&](std::size_t run) {
    for (std::size_t i = run * kRun; i < std::min(triangles.size(), (run + 1) * kRun); ++i)
      powers[i] = power_of(objects[triangles[i].object], triangles[i].index, materials);
  });
  return powers;
}

void Emitters::find_extent() {
  scene::Aabb box;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    if (choice_.probability(i) == 0.0f) continue;
    for (const glm::vec3& p : objects_[triangles_[i].object].positions_ws(triangles_[i].index)) box.add(p);
  }
  if (box.empty()) return;
  center_ = 0.5f * (box.min + box.max);
  radius_m_ = 0.5f * glm::length(box.max - box.min);
}

// All power in one point, seen from outside the sphere that holds it; inside, as if at its rim.
float Emitters::irradiance_at(const glm::vec3& position) const {
  const glm::vec3 away = position - center_;
  const float squared = std::max(glm::dot(away, away), std::max(radius_m_ * radius_m_, 1e-12f));
  return static_cast<float>(choice_.total()) / squared;
}

std::optional<Emitters::Sample> Emitters::sample(const glm::vec3& position, float u_triangle,
                                                 const glm::vec2& u) const {
  const Distribution1d::Sample chosen = choice_.sample(u_triangle);
  const auto [object, triangle] = triangles_[chosen.index];
  const glm::vec3 place = shading::sample_triangle(u);
  Sample sample{.point = surface_point(objects_[object], triangle, place.x, place.y)};
  const SurfacePoint& p = sample.point;
  sample.front = glm::dot(position - p.position_ws, p.geometric_normal_ws) > 0.0f;
  if (!sample.front && !materials_.double_sided(objects_[object].material)) return std::nullopt;
  sample.pdf_m2 = chosen.probability / p.area_m2;
  // The largest mip: what the eye would see from near.
  const Footprint sharp{0.0f, chosen.rest};
  sample.radiance = materials_.emission(p, sharp) * materials_.transparency(p, sharp).opacity;
  return sample;
}

float Emitters::pdf_m2(std::uint32_t object, std::uint32_t triangle, float area_m2) const {
  if (first_[object] == kDark) return 0.0f;
  const float probability = choice_.probability(first_[object] + triangle);
  return probability > 0.0f ? probability / area_m2 : 0.0f;
}

}  // namespace velarium::reference
