#include "scenes/atrium_daylight.hpp"

#include "core/jobs.hpp"
#include "scene/snapshot.hpp"
#include "scenes/atrium_plan.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

using glm::vec3;

constexpr std::uint32_t kSteps = 256;
constexpr std::size_t kRays = 40;  // steps of 1/40 between rays melt into gradients between vertices

struct Block {
  vec3 low, high;
};

// What keeps daylight out. The architraves are as wide as the columns, the roofs reach from the eaves to the walls.
constexpr float kHigh = 4.6f, kFar = 12.0f, kEave = 0.45f, kHalfBeam = 0.22f, kBeamBottom = 3.45f;
constexpr std::array kBlocks{
    Block{{-kFar, 4.46f, kCourt.y - kEave}, {kFar, kHigh, kFar}},
    Block{{-kFar, 4.46f, -kFar}, {kFar, kHigh, -kCourt.y + kEave}},
    Block{{kCourt.x - kEave, 4.46f, -kCourt.y}, {kFar, kHigh, kCourt.y}},
    Block{{-kFar, 4.46f, -kCourt.y}, {-kCourt.x + kEave, kHigh, kCourt.y}},
    Block{{-kFar, 0.0f, kWalls.y}, {kFar, kHigh, kFar}},
    Block{{-kFar, 0.0f, -kFar}, {kFar, kHigh, -kWalls.y}},
    Block{{kWalls.x, 0.0f, -kFar}, {kFar, kHigh, kFar}},
    Block{{-kFar, 0.0f, -kFar}, {-kWalls.x, kHigh, kFar}},
    Block{{kCourt.x - kHalfBeam, kBeamBottom, -kCourt.y}, {kCourt.x + kHalfBeam, kHigh, kCourt.y}},
    Block{{-kCourt.x - kHalfBeam, kBeamBottom, -kCourt.y}, {-kCourt.x + kHalfBeam, kHigh, kCourt.y}},
    Block{{-kCourt.x, kBeamBottom, kCourt.y - kHalfBeam}, {kCourt.x, kHigh, kCourt.y + kHalfBeam}},
    Block{{-kCourt.x, kBeamBottom, -kCourt.y - kHalfBeam}, {kCourt.x, kHigh, -kCourt.y + kHalfBeam}},
};

// Light that comes back, as a share of what the surroundings would have sent from there.
constexpr float kFromBlocks = 0.18f, kFromCourt = 0.9f, kFromWalks = 0.42f;

// Blocks that the ray starts in do not count: they stand for finer shapes.
bool enters(const Block& block, const vec3& from, const vec3& inverse_direction) {
  const vec3 a = (block.low - from) * inverse_direction, b = (block.high - from) * inverse_direction;
  const vec3 first = glm::min(a, b), last = glm::max(a, b);
  const float enter = std::max({first.x, first.y, first.z}), leave = std::min({last.x, last.y, last.z});
  return enter > 0.0f && enter < leave;
}

float light_from(const vec3& from, const vec3& direction) {
  const vec3 inverse = 1.0f / direction;
  for (const Block& block : kBlocks) {
    if (enters(block, from, inverse)) return kFromBlocks;
  }
  if (direction.y > 0.0f) return 1.0f;
  const vec3 hit = from - direction * (std::max(from.y, 0.0f) * inverse.y);
  const bool court = std::abs(hit.x) < kCourt.x && std::abs(hit.z) < kCourt.y;
  return court ? kFromCourt : kFromWalks;
}

// Directions around +z, as dense as the cosine: a spiral on the disc [Malley], each golden angle further.
std::array<vec3, kRays> cosine_directions() {
  constexpr float kGoldenAngle = 2.39996323f;
  std::array<vec3, kRays> directions;
  for (std::size_t i = 0; i < kRays; ++i) {
    const float r2 = (static_cast<float>(i) + 0.5f) / kRays, angle = kGoldenAngle * static_cast<float>(i);
    directions[i] = {std::sqrt(r2) * std::cos(angle), std::sqrt(r2) * std::sin(angle), std::sqrt(1.0f - r2)};
  }
  return directions;
}

float daylight_at(const vec3& position, const vec3& normal) {
  static const std::array<vec3, kRays> directions = cosine_directions();
  constexpr float kClear = 0.02f;  // metres off the surface, over the block that stands for it
  const vec3 other = std::abs(normal.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
  const vec3 tangent = glm::normalize(glm::cross(other, normal)), bitangent = glm::cross(normal, tangent);
  float sum = 0.0f;
  for (const vec3& d : directions)
    sum += light_from(position + kClear * normal, d.x * tangent + d.y * bitangent + d.z * normal);
  return sum / kRays;
}

void measure(Primitive& p, const glm::mat4& world_from_object) {
  const glm::mat3 normals = glm::inverseTranspose(glm::mat3(world_from_object));
  for (std::size_t i = 0; i < p.vertex_count(); ++i) {
    const vec3 position(world_from_object * glm::vec4(p.vertices.positions[i], 1.0f));
    const float light = daylight_at(position, glm::normalize(normals * p.vertices.normals[i]));
    p.uv[1].emplace_back((light * (kSteps - 1) + 0.5f) / kSteps, 0.5f);
  }
}

}  // namespace

Image daylight_ramp() {
  Image image{.name = "daylight", .width = kSteps, .height = 1};
  for (std::uint32_t step = 0; step < kSteps; ++step) {
    const auto value = static_cast<std::uint8_t>(step);
    image.rgba.insert(image.rgba.end(), {value, value, value, 255});
  }
  return image;
}

void measure_daylight(Scene& scene) {
  std::vector<const Instance*> firsts(scene.primitives.size(), nullptr);
  const SceneSnapshot snapshot = snapshot_at(scene, 0.0f, "");
  for (const Instance& instance : snapshot.instances) {
    if (firsts[instance.primitive] == nullptr) firsts[instance.primitive] = &instance;
  }
  parallel_for(scene.primitives.size(), [&](std::size_t i) {
    measure(scene.primitives[i], firsts[i] != nullptr ? glm::mat4(firsts[i]->world_from_object) : glm::mat4(1.0f));
  });
}

}  // namespace velarium::scene::atrium
