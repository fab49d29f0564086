#include "upload/triangle_order.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>

namespace velarium::upload {
namespace {

// Unsigned integers that stand in the order of the numbers: those below zero have all their bits turned, others the
// sign alone.
std::uint32_t ordered_bits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return bits ^ ((bits >> 31u) != 0 ? 0xffffffffu : 0x80000000u);
}

}  // namespace

double Viewpoint::farness(const glm::dvec3& from_eye) const {
  return backward == glm::dvec3(0.0) ? glm::dot(from_eye, from_eye) : -glm::dot(from_eye, backward);
}

std::vector<std::uint32_t> far_to_near(std::span<const std::uint32_t> indices, std::span<const glm::vec3> positions,
                                       const glm::dmat4& world_from_object, const Viewpoint& view) {
  const glm::dmat3 turn(world_from_object);
  const glm::dvec3 shift = glm::dvec3(world_from_object[3]) - view.eye;
  const std::size_t count = indices.size() / 3;
  std::vector<std::uint64_t> order(count);  // nearness above, number below: one comparison sorts by both
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 sum = glm::dvec3(positions[indices[3 * i]]) + glm::dvec3(positions[indices[3 * i + 1]]) +
                           glm::dvec3(positions[indices[3 * i + 2]]);
    const auto farness = static_cast<float>(view.farness(turn * (sum / 3.0) + shift));
    order[i] = std::uint64_t{~ordered_bits(farness)} << 32u | i;
  }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> sorted;
  sorted.reserve(3 * count);
  for (const std::uint64_t entry : order) {
    const auto triangle = indices.subspan(3 * (entry & 0xffffffffu), 3);
    sorted.insert(sorted.end(), triangle.begin(), triangle.end());
  }
  return sorted;
}

}  // namespace velarium::upload
