// Vessels of clay and bronze, and laurels in pots.

#include "scenes/atrium_parts.hpp"

#include "scenes/atrium_paint.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

constexpr float kCrownHeight = 1.28f;  // of the middle of a laurel

void append_handles(Primitive& whole, std::span<const glm::vec3> path, float radius) {
  const Primitive handle = tube(path, radius, 8);
  append(whole, handle);
  append(whole, handle, glm::rotate(glm::mat4(1), glm::pi<float>(), glm::vec3(0, 1, 0)));
}

Primitive amphora() {
  Primitive whole = lathe({{0.0f, 0.0f},
                           {0.09f, 0.0f},
                           {0.10f, 0.02f},
                           {0.07f, 0.05f},
                           {0.10f, 0.10f},
                           {0.19f, 0.26f},
                           {0.235f, 0.42f},
                           {0.24f, 0.52f},
                           {0.21f, 0.64f},
                           {0.14f, 0.73f},
                           {0.085f, 0.78f},
                           {0.07f, 0.84f},
                           {0.072f, 0.94f},
                           {0.10f, 0.96f},
                           {0.105f, 0.99f},
                           {0.08f, 1.0f},
                           {0.058f, 0.97f},
                           {0.05f, 0.8f}},
                          24, 0.8f);
  const std::array path{glm::vec3(0.06f, 0.90f, 0), glm::vec3(0.13f, 0.925f, 0), glm::vec3(0.185f, 0.89f, 0),
                        glm::vec3(0.20f, 0.80f, 0), glm::vec3(0.195f, 0.70f, 0), glm::vec3(0.18f, 0.64f, 0)};
  append_handles(whole, path, 0.017f);
  return whole;
}

Primitive krater() {
  Primitive whole = lathe({{0.0f, 0.0f},    {0.17f, 0.0f},  {0.175f, 0.03f}, {0.12f, 0.06f}, {0.06f, 0.10f},
                           {0.055f, 0.15f}, {0.09f, 0.18f}, {0.20f, 0.24f},  {0.25f, 0.31f}, {0.26f, 0.36f},
                           {0.24f, 0.40f},  {0.23f, 0.48f}, {0.25f, 0.58f},  {0.30f, 0.66f}, {0.315f, 0.68f},
                           {0.30f, 0.69f},  {0.26f, 0.66f}, {0.21f, 0.56f},  {0.20f, 0.40f}, {0.0f, 0.30f}},
                          48, 1.2f);
  const std::array path{glm::vec3(0.24f, 0.33f, 0), glm::vec3(0.31f, 0.34f, 0), glm::vec3(0.35f, 0.40f, 0),
                        glm::vec3(0.34f, 0.48f, 0), glm::vec3(0.29f, 0.53f, 0), glm::vec3(0.235f, 0.52f, 0)};
  append_handles(whole, path, 0.016f);
  return whole;
}

Primitive pedestal() {
  const Profile sides{{0.04f, 0.0f}, {0.04f, 0.08f}, {0.02f, 0.11f}, {0.0f, 0.13f}, {0.0f, 0.40f},
                      {0.0f, 0.66f}, {0.02f, 0.69f}, {0.05f, 0.72f}, {0.05f, 0.8f}, {-0.24f, 0.8f}};
  return rectangle_moulding(glm::vec2(0.24f), sides, 0.24f);
}

Primitive pot() {
  return lathe({{0.20f, 0.0f},
                {0.21f, 0.02f},
                {0.27f, 0.36f},
                {0.30f, 0.37f},
                {0.31f, 0.40f},
                {0.31f, 0.46f},
                {0.29f, 0.47f},
                {0.265f, 0.45f},
                {0.25f, 0.38f}},
               32, 0.8f);
}

// A leaf of two triangles, darker the less far out (`depth`, 1 at the outside) it grows, its normal bent towards that
// of the crown so that the crown is shaded as one.
void append_leaf(Primitive& crown, const glm::vec3& center, const glm::vec3& outwards, float depth, int number) {
  const auto random = [number](std::uint32_t what) { return cell_noise(number, 7, what) * 2.0f - 1.0f; };
  const glm::vec3 tip = glm::normalize(outwards + 0.8f * glm::vec3(random(1), random(2) + 0.3f, random(3)));
  const glm::vec3 side = glm::normalize(glm::cross(tip, glm::vec3(random(4), 1.0f, random(5))));
  const glm::vec3 flat = glm::normalize(glm::cross(side, tip));
  const float size = 0.075f + 0.02f * random(6);
  const auto first = static_cast<std::uint32_t>(crown.vertex_count());
  const std::array corners{center, center + size * (0.55f * tip + 0.34f * side), center + size * 1.3f * tip,
                           center + size * (0.55f * tip - 0.34f * side)};
  const float shade = (0.5f + 0.5f * cell_noise(number, 8, 9)) * depth * depth;
  for (const glm::vec3& corner : corners) {
    crown.vertices.positions.push_back(corner);
    crown.vertices.normals.push_back(glm::normalize(flat + 0.6f * outwards));
    crown.uv[0].emplace_back(0.0f);
    crown.colors.emplace_back(shade, shade, 0.8f * shade, 1.0f);
    crown.bounds.add(corner);
  }
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) crown.indices.push_back(first + i);
}

Primitive laurel_crown() {
  constexpr int kLeaves = 800;
  constexpr float kGoldenAngle = 2.39996323f, kRadius = 0.40f;
  Primitive crown;
  for (int i = 0; i < kLeaves; ++i) {
    const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / kLeaves,
                angle = kGoldenAngle * static_cast<float>(i);
    const float ring = std::sqrt(1.0f - y * y);
    const glm::vec3 outwards(ring * std::cos(angle), y, ring * std::sin(angle));
    const float depth = 0.62f + 0.38f * cell_noise(i, 3, 10);
    append_leaf(crown, glm::vec3(0, kCrownHeight, 0) + kRadius * depth * outwards, outwards, depth, i);
  }
  return crown;
}

void add_laurels(SceneBuilder& builder) {
  const auto clay = builder.add_mesh("pot", pot(), kTerracotta);
  Primitive ground = surface(20, 1, [](float s, float t) {
    const float angle = s * glm::two_pi<float>(), radius = 0.265f * (1.0f - t);
    return SurfacePoint{{radius * std::sin(angle), 0.42f, radius * std::cos(angle)}, {s, t}};
  });
  append(ground, lathe({{0.028f, 0.40f}, {0.020f, 0.7f}, {0.016f, 1.2f}}, 8, 0.1f));
  // Darkness inside the crown, behind the leaves.
  append(ground, uv_sphere(0.24f, 8, 14), glm::translate(glm::mat4(1), glm::vec3(0.0f, kCrownHeight, 0.0f)));
  const auto soil = builder.add_mesh("soil", std::move(ground), kSoil);
  const auto crown = builder.add_mesh("laurel", laurel_crown(), kLaurel);
  for (const float x : {-4.7f, 4.7f}) {
    for (const float z : {-6.2f, -2.1f, 2.1f, 5.4f}) {
      for (const auto mesh : {clay, soil, crown}) builder.place_mesh(mesh, {x, 0.0f, z}, x + z);
    }
  }
}

}  // namespace

void add_vessels(SceneBuilder& builder) {
  const auto jar = builder.add_mesh("amphora", amphora(), kTerracotta);
  const auto glazed = builder.add_mesh("glazed amphora", amphora(), kGlaze);
  const std::array<glm::vec2, 4> group{{{0.0f, 0.0f}, {0.62f, 0.1f}, {0.30f, -0.5f}, {-0.55f, -0.1f}}};
  for (const int side : {1, 3, 2}) {
    for (const float along : {-3.0f, 3.0f}) {
      for (std::size_t i = 0; i < group.size(); ++i) {
        const Spot spot = on_side(side, along + group[i].x, 2.55f + group[i].y, kWalkFloor);
        place(builder, i == 2 ? glazed : jar, {spot.position, spot.yaw + 1.3f * static_cast<float>(i)},
              1.0f - 0.13f * static_cast<float>(i));
      }
    }
  }
  const auto stand = builder.add_mesh("pedestal", pedestal(), kMarble);
  const auto bowl = builder.add_mesh("krater", krater(), kBronze);
  for (const float x : {-2.9f, 2.9f}) {
    for (const float z : {-7.0f, 0.0f}) {
      builder.place_mesh(stand, {x, 0.0f, z});
      builder.place_mesh(bowl, {x, 0.8f, z}, 0.5f);
    }
  }
  add_laurels(builder);
}

}  // namespace velarium::scene::atrium
