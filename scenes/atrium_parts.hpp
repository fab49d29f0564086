#pragma once

// The parts of the atrium, one .cpp each. A mesh that is placed several times is lit by the sky as its first placement
// is (atrium_daylight.hpp), so the first one is where most of them are alike.

#include "scenes/atrium_plan.hpp"
#include "scenes/shapes.hpp"

namespace velarium::scene::atrium {

void add_materials(SceneBuilder& builder);  // in the order of Stuff
void add_columns(SceneBuilder& builder);
void add_arches(SceneBuilder& builder);
void add_walls(SceneBuilder& builder);
void add_roof(SceneBuilder& builder);
void add_floors(SceneBuilder& builder);
void add_vessels(SceneBuilder& builder);
void add_awnings(SceneBuilder& builder);
void add_torches(SceneBuilder& builder, bool lit, float radius);  // unlit ones are meshes alone; radius of their lights
void add_beams(SceneBuilder& builder);                            // the sun, and a lantern that throws a pattern
void add_extra_lights(SceneBuilder& builder, std::uint32_t count);  // lights without meshes

// A torch's light. As bright against the evening sky as pictures at exposure 0 can take: the walls around a torch stay
// below white.
inline constexpr float kTorchCandela = 2.6f, kTorchRange = 8.0f;  // metres
inline constexpr float kFlameRadius = 0.05f;                      // metres, of a sphere as large as a flame is seen
inline constexpr glm::vec3 kFireColor{1.0f, 0.52f, 0.20f};

inline void place(SceneBuilder& builder, std::uint32_t mesh, const Spot& spot, float scale = 1.0f) {
  builder.place_mesh(mesh, spot.position, spot.yaw, glm::vec3(scale));
}

}  // namespace velarium::scene::atrium
