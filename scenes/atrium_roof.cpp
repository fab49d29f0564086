// What the columns carry: architrave, cornice, coffered ceilings, and roofs of flat and half-round tiles.

#include "scenes/atrium_parts.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

constexpr float kCut = 0.5f;  // metres between vertices along mouldings, for the daylight on them
constexpr float kTileWidth = 0.28f, kTileLength = 0.5f;
constexpr float kEaveOut = -0.66f, kRidgeOut = 3.3f, kRidgeRise = 1.15f;  // of the roofs, from the columns' axis

void add_architraves(SceneBuilder& builder) {
  const Profile section{{-0.21f, 4.05f}, {-0.21f, 3.77f}, {-0.27f, 3.76f}, {-0.27f, 3.72f}, {-0.24f, 3.71f},
                        {-0.24f, 3.59f}, {-0.22f, 3.58f}, {-0.22f, 3.45f}, {0.22f, 3.45f},  {0.22f, 4.25f}};
  const auto beam = builder.add_mesh("architrave", straight_moulding(kCourt.y - 0.2f, section, kCut), kMarble);
  for (const int side : {1, 3}) place(builder, beam, on_side(side, 0.0f, 0.0f, 0.0f));
}

void add_cornice(SceneBuilder& builder) {
  const Profile section{{-0.62f, 4.50f}, {-0.62f, 4.45f}, {-0.60f, 4.43f}, {-0.56f, 4.40f}, {-0.52f, 4.38f},
                        {-0.50f, 4.37f}, {-0.50f, 4.30f}, {-0.34f, 4.29f}, {-0.34f, 4.16f}, {-0.31f, 4.15f},
                        {-0.28f, 4.12f}, {-0.27f, 4.08f}, {-0.27f, 4.05f}, {-0.20f, 4.05f}};
  Primitive whole = rectangle_moulding(kCourt, section, kCut);
  const Primitive dentil = box({-0.035f, 4.19f, -0.43f}, {0.035f, 4.29f, -0.33f});
  constexpr float kPitch = 0.14f;
  for (int side = 0; side < 4; ++side) {
    const float half = (side % 2 == 0 ? kCourt.x : kCourt.y) - 0.45f;
    const int count = static_cast<int>(half / kPitch);
    for (int i = -count; i <= count; ++i) {
      const Spot spot = on_side(side, kPitch * static_cast<float>(i), 0.0f, 0.0f);
      append(whole, dentil, glm::rotate(glm::translate(glm::mat4(1), spot.position), spot.yaw, glm::vec3(0, 1, 0)));
    }
  }
  builder.place_mesh(builder.add_mesh("cornice", std::move(whole), kMarble), glm::vec3(0.0f));
}

// Three coffers side by side, from the columns (z = 0) to the wall.
void add_ceilings(SceneBuilder& builder) {
  const Profile coffer{{-0.12f, 0.20f}, {-0.12f, 0.14f}, {-0.06f, 0.13f}, {-0.06f, 0.08f},
                       {0.0f, 0.07f},   {0.0f, 0.0f},    {0.12f, 0.0f}};
  const Primitive frame = rectangle_moulding(glm::vec2(0.38f), coffer, 0.4f);
  const Primitive panel = surface(2, 2, [](float s, float t) {
    return SurfacePoint{{0.26f * (2.0f * s - 1.0f), 0.2f, 0.26f * (2.0f * t - 1.0f)}, {s, t}};
  });
  const Primitive petals = surface(24, 3, [](float s, float t) {
    const float angle = s * glm::two_pi<float>(), lobe = 1.0f + 0.16f * std::cos(8.0f * angle) * t;
    const float radius = 0.16f * t * lobe;
    return SurfacePoint{{radius * std::sin(angle), 0.13f + 0.05f * t * t, radius * std::cos(angle)}, {s, t}};
  });
  Primitive frames, panels, rosettes;
  for (int i = 0; i < 3; ++i) {
    const auto to = glm::translate(glm::mat4(1), {0.0f, 0.0f, static_cast<float>(i) + 0.5f});
    append(frames, frame, to);
    append(panels, panel, to);
    append(rosettes, petals, to);
  }
  const std::array meshes{builder.add_mesh("coffers", std::move(frames), kWood),
                          builder.add_mesh("coffer grounds", std::move(panels), kAzure),
                          builder.add_mesh("rosettes", std::move(rosettes), kGilt)};
  for (const int side : {1, 3, 0, 2}) {
    const int half = static_cast<int>(side % 2 == 0 ? kCourt.x : kWalls.y);
    for (int i = -half; i < half; ++i) {
      for (const auto mesh : meshes) place(builder, mesh, on_side(side, static_cast<float>(i) + 0.5f, 0.0f, kCeiling));
    }
  }
}

// Height above the slope: half-round tiles over the joints of flat ones, each row lying on the one below.
float tile_relief(float along, float up) {
  const float place = along / kTileWidth - std::floor(along / kTileWidth) - 0.5f;
  const float round = 1.0f - place * place / 0.0625f;
  const float row = up / kTileLength - std::floor(up / kTileLength);
  return 0.075f * std::sqrt(std::max(round, 0.0f)) - 0.035f * row;
}

// Falls towards the court (-z), which it meets at z = kEaveOut. The eaves are shorter than the ridge: valleys.
Primitive roof(float half_court) {
  const float eave = half_court + kEaveOut, ridge = half_court + kRidgeOut, length = kRidgeOut - kEaveOut;
  const auto columns = static_cast<std::uint32_t>(2.0f * ridge / kTileWidth * 4.0f);
  constexpr std::uint32_t kRows = 16;
  return surface(columns, kRows, [=](float s, float t) {
    const float limit = eave + (ridge - eave) * t;
    const float along = std::clamp((1.0f - 2.0f * s) * ridge, -limit, limit);
    const float up = t * length;
    const float y = kCorniceTop + 0.02f + kRidgeRise * t + tile_relief(along, up);
    return SurfacePoint{{along, y, kEaveOut + up}, {along, -up}};
  });
}

void add_roofs(SceneBuilder& builder) {
  const auto beside = builder.add_mesh("long roof", roof(kCourt.y), kRoofTile);
  const auto across = builder.add_mesh("short roof", roof(kCourt.x), kRoofTile);
  // Palmettes that close the half-round tiles at the eaves.
  const auto palmette = builder.add_mesh(
      "antefix",
      surface(8, 3,
              [](float s, float t) {
                const float angle = (s - 0.5f) * glm::pi<float>(), r = t * (1.0f + 0.12f * std::cos(7.0f * angle));
                return SurfacePoint{
                    {-0.085f * r * std::sin(angle), 0.15f * r * std::cos(angle), -0.04f * (1.0f - t * t)}, {s, t}};
              }),
      kTerracotta);
  for (int side = 0; side < 4; ++side) {
    place(builder, side % 2 == 0 ? across : beside, on_side(side, 0.0f, 0.0f, 0.0f));
    const float half = (side % 2 == 0 ? kCourt.x : kCourt.y) + kEaveOut;
    const int count = static_cast<int>(half / kTileWidth);
    for (int i = -count; i < count; ++i)
      place(builder, palmette, on_side(side, (static_cast<float>(i) + 0.5f) * kTileWidth, kEaveOut, kCorniceTop));
  }
}

}  // namespace

void add_roof(SceneBuilder& builder) {
  add_architraves(builder);
  add_cornice(builder);
  add_ceilings(builder);
  add_roofs(builder);
}

}  // namespace velarium::scene::atrium
