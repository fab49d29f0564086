#pragma once

// The plan of the atrium, metres. The court is open to the sky inside the columns, which stand on a low step; walks
// under a coffered ceiling lead around it, between the columns and the walls. Its long axis is z.

#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace velarium::scene::atrium {

inline constexpr glm::vec2 kCourt{6.0f, 8.0f};  // half distances, x and z, of the axes of the columns
inline constexpr glm::vec2 kWalls{9.0f, 11.0f};
inline constexpr glm::vec2 kStep{5.62f, 7.62f};  // the edge of the step
inline constexpr glm::vec2 kPool{2.0f, 3.6f};    // the water
inline constexpr float kPoolRim = 0.45f;         // its width
inline constexpr float kWalkFloor = 0.15f, kCeiling = 4.25f, kWallTop = 4.35f;
inline constexpr float kColumnHeight = 3.3f;
inline constexpr float kArchedScale = 0.85f;  // columns below arches are smaller
inline constexpr float kCorniceBottom = 4.05f, kCorniceTop = 4.5f;
inline constexpr float kBay = 2.4f;  // between columns of the short sides, below arches

// Materials, in the order of the scene's table.
// clang-format off
enum Stuff : std::uint32_t {
  kMarble, kTravertine, kSectile, kMosaic, kPoolMosaic, kFresco, kBrick, kRoofTile, kTerracotta, kGlaze,
  kBronze, kGilt, kWood, kAzure, kSaffron, kCrimson, kWater, kFlame, kLaurel, kSoil,
};
// clang-format on

struct Spot {
  glm::vec3 position;
  float yaw;  // radians; local +z points away from the court
};

// Side 0: +z, 1: +x, 2: -z, 3: -x. `out`: metres from the columns' axis; `along`: to the right, looking to the court.
inline Spot on_side(int side, float along, float out, float height) {
  const float half = side % 2 == 0 ? kCourt.y : kCourt.x;
  const float yaw = static_cast<float>(side) * glm::half_pi<float>();
  const float s = std::sin(yaw), c = std::cos(yaw);
  return {{c * along + s * (half + out), height, c * (half + out) - s * along}, yaw};
}

}  // namespace velarium::scene::atrium
