// Painted walls, doors in marble frames.

#include "scenes/atrium_parts.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace velarium::scene::atrium {
namespace {

constexpr float kDoorHalf = 0.75f, kDoorHeight = 2.7f;

// Faces +z, its middle at x = 0, standing on y = 0.
Primitive painted_wall(float half_width) {
  const float height = kWallTop - kWalkFloor;
  const auto at = [=](float s, float t) {
    const float x = (2.0f * s - 1.0f) * half_width, y = t * height;
    return SurfacePoint{{x, y, 0.0f}, {x + 1.5f, height - y}};
  };
  return surface(static_cast<std::uint32_t>(4.0f * half_width), 12, at);
}

Primitive door_frame() {
  // Outwards: from the wall over the face to the opening; jambs lean on it from both sides and above.
  const float out = kDoorHalf + 0.22f;
  Primitive whole;
  for (const float x : {-1.0f, 1.0f}) {
    const float near = x < 0 ? -out : kDoorHalf, far = x < 0 ? -kDoorHalf : out;
    append(whole, box({near, 0.0f, 0.0f}, {far, kDoorHeight, 0.10f}));
    append(whole, box({near + 0.05f, 0.0f, 0.10f}, {far - 0.05f, kDoorHeight, 0.125f}));
  }
  append(whole, box({-out, kDoorHeight, 0.0f}, {out, kDoorHeight + 0.24f, 0.10f}));
  append(whole, box({-out - 0.05f, kDoorHeight + 0.24f, 0.0f}, {out + 0.05f, kDoorHeight + 0.29f, 0.16f}));
  append(whole, box({-out - 0.10f, kDoorHeight + 0.29f, 0.0f}, {out + 0.10f, kDoorHeight + 0.36f, 0.21f}));
  append(whole, box({-out, 0.0f, 0.0f}, {out, 0.03f, 0.2f}));
  return whole;
}

// Two leaves of four panels.
Primitive door_leaves() {
  Primitive whole = box({-kDoorHalf, 0.0f, 0.0f}, {kDoorHalf, kDoorHeight, 0.02f});
  for (const float hinge : {-kDoorHalf, 0.0f}) {
    const float left = hinge + 0.01f, right = hinge + kDoorHalf - 0.01f;
    append(whole, box({left, 0.0f, 0.02f}, {left + 0.10f, kDoorHeight, 0.055f}));
    append(whole, box({right - 0.10f, 0.0f, 0.02f}, {right, kDoorHeight, 0.055f}));
    for (int i = 0; i <= 4; ++i) {
      const float y = static_cast<float>(i) * (kDoorHeight - 0.12f) / 4.0f;
      append(whole, box({left + 0.10f, y, 0.02f}, {right - 0.10f, y + 0.12f, 0.055f}));
    }
  }
  return whole;
}

Primitive door_bronzes() {
  Primitive whole;
  const Primitive stud = uv_sphere(0.018f, 6, 10);
  for (const float hinge : {-kDoorHalf, 0.0f}) {
    for (int i = 0; i <= 4; ++i) {
      const float y = 0.06f + static_cast<float>(i) * (kDoorHeight - 0.12f) / 4.0f;
      for (int k = 0; k < 5; ++k)
        append(whole, stud, glm::translate(glm::mat4(1), {hinge + 0.07f + 0.1525f * static_cast<float>(k), y, 0.055f}));
    }
  }
  const Primitive ring = lathe({{0.06f, -0.01f},
                                {0.07f, -0.007f},
                                {0.074f, 0.0f},
                                {0.07f, 0.007f},
                                {0.06f, 0.01f},
                                {0.052f, 0.007f},
                                {0.05f, 0.0f},
                                {0.052f, -0.007f},
                                {0.06f, -0.01f}},
                               24, 0.4f);
  for (const float x : {-0.09f, 0.09f}) {
    const auto upright = glm::rotate(glm::translate(glm::mat4(1), {x, 1.15f, 0.075f}), 1.45f, glm::vec3(1, 0, 0));
    append(whole, ring, upright);
  }
  return whole;
}

}  // namespace

void add_walls(SceneBuilder& builder) {
  const auto inward = [](Spot spot) {
    spot.yaw += glm::pi<float>();
    return spot;
  };
  const float reach = kWalls.x - kCourt.x;
  const auto long_wall = builder.add_mesh("long wall", painted_wall(kWalls.y), kFresco);
  const auto short_wall = builder.add_mesh("short wall", painted_wall(kWalls.x), kFresco);
  const auto frame = builder.add_mesh("door frame", door_frame(), kMarble);
  const auto leaves = builder.add_mesh("door", door_leaves(), kWood);
  const auto bronzes = builder.add_mesh("door bronzes", door_bronzes(), kBronze);
  for (int side = 0; side < 4; ++side) {
    place(builder, side % 2 == 0 ? short_wall : long_wall, inward(on_side(side, 0.0f, reach, kWalkFloor)));
    for (const float along : {-4.5f, 0.0f, 4.5f}) {
      if ((side % 2 == 0) != (along == 0.0f)) continue;
      for (const auto mesh : {frame, leaves, bronzes})
        place(builder, mesh, inward(on_side(side, along, reach, kWalkFloor)));
    }
  }
}

}  // namespace velarium::scene::atrium
