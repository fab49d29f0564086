// Pavements, the step under the columns, and the pool with its fountain.

#include "scenes/atrium_parts.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace velarium::scene::atrium {
namespace {

constexpr float kCut = 0.5f;  // metres between vertices, for the daylight on them
constexpr float kWaterLevel = 0.13f, kPoolFloor = -0.45f;

Primitive floor_patch(const glm::vec2& low, const glm::vec2& high, float y) {
  const glm::vec2 size = high - low, cuts = glm::ceil(size / kCut);
  return surface(static_cast<std::uint32_t>(cuts.x), static_cast<std::uint32_t>(cuts.y), [=](float s, float t) {
    const glm::vec2 q(low.x + s * size.x, high.y - t * size.y);
    return SurfacePoint{{q.x, y, q.y}, q};
  });
}

// The floor between two rectangles around the origin.
Primitive ring_floor(const glm::vec2& inner, const glm::vec2& outer, float y) {
  Primitive whole = floor_patch({-outer.x, inner.y}, outer, y);
  append(whole, floor_patch(-outer, {outer.x, -inner.y}, y));
  append(whole, floor_patch({inner.x, -inner.y}, {outer.x, inner.y}, y));
  append(whole, floor_patch({-outer.x, -inner.y}, {-inner.x, inner.y}, y));
  return whole;
}

void add_pool(SceneBuilder& builder) {
  const Profile rim{{kPoolRim, 0.0f},
                    {kPoolRim, 0.04f},
                    {kPoolRim - 0.05f, 0.07f},
                    {kPoolRim - 0.05f, 0.16f},
                    {kPoolRim - 0.02f, 0.19f},
                    {kPoolRim - 0.02f, 0.225f},
                    {kPoolRim - 0.04f, 0.24f},
                    {-0.02f, 0.24f},
                    {-0.04f, 0.225f},
                    {-0.04f, 0.19f},
                    {0.0f, 0.17f},
                    {0.0f, kPoolFloor}};
  builder.place_mesh(builder.add_mesh("pool rim", rectangle_moulding(kPool, rim, kCut), kTravertine), {});
  builder.place_mesh(builder.add_mesh("pool floor", floor_patch(-kPool, kPool, kPoolFloor), kPoolMosaic), {});
  builder.place_mesh(builder.add_mesh("water", floor_patch(-kPool, kPool, kWaterLevel), kWater), {});
}

// A basin on a foot in the middle of the pool, full to the brim.
void add_fountain(SceneBuilder& builder) {
  const Profile basin{{0.40f, -0.45f}, {0.40f, 0.22f}, {0.36f, 0.26f}, {0.20f, 0.30f}, {0.15f, 0.36f}, {0.13f, 0.46f},
                      {0.15f, 0.58f},  {0.17f, 0.64f}, {0.14f, 0.70f}, {0.15f, 0.74f}, {0.34f, 0.80f}, {0.54f, 0.90f},
                      {0.66f, 1.01f},  {0.70f, 1.05f}, {0.71f, 1.09f}, {0.69f, 1.11f}, {0.64f, 1.10f}, {0.52f, 0.99f},
                      {0.30f, 0.92f},  {0.06f, 0.90f}, {0.06f, 1.16f}, {0.09f, 1.22f}, {0.05f, 1.30f}, {0.0f, 1.33f}};
  builder.place_mesh(builder.add_mesh("fountain", lathe(basin, 64, 3.0f), kMarble), {});
  const Primitive brim = surface(48, 4, [](float s, float t) {
    const float angle = s * glm::two_pi<float>(), radius = 0.63f * (1.0f - t);
    const glm::vec2 q(radius * std::sin(angle), radius * std::cos(angle));
    return SurfacePoint{{q.x, 1.085f, q.y}, q};
  });
  builder.place_mesh(builder.add_mesh("fountain water", brim, kWater), {});
}

}  // namespace

void add_floors(SceneBuilder& builder) {
  const Profile step{{0.0f, kWalkFloor}, {-0.015f, kWalkFloor - 0.02f}, {-0.015f, 0.05f}, {0.0f, 0.04f}, {0.0f, 0.0f}};
  builder.place_mesh(builder.add_mesh("step", rectangle_moulding(kStep, step, kCut), kTravertine), {});
  const glm::vec2 stylobate = kCourt + 0.38f;
  builder.place_mesh(builder.add_mesh("stylobate", ring_floor(kStep, stylobate, kWalkFloor), kTravertine), {});
  builder.place_mesh(builder.add_mesh("walk floor", ring_floor(stylobate, kWalls, kWalkFloor), kMosaic), {});
  builder.place_mesh(builder.add_mesh("court floor", ring_floor(kPool + kPoolRim, kStep, 0.0f), kSectile), {});
  add_pool(builder);
  add_fountain(builder);
}

}  // namespace velarium::scene::atrium
