#pragma once

// A map of depth from the sun: which box of the world it sees. Shared by all passes that draw one. In double precision,
// so that texels stay where they are in the world wherever the viewer stands.

#include "gpu/vulkan.hpp"
#include "graph/context.hpp"
#include "shading/host.hpp"
#include "upload/tables.hpp"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace velarium::passes {

// Filters look at texels beside the one that they are centred on.
inline constexpr double kGuardTexels = 2.0;

// A map: a square of the world seen from the sun.
struct SunMap {
  glm::dmat3 axes{1.0};              // light space = axes * world
  glm::dvec2 corner{0.0};            // light space: where u = v = 0
  double side = 1.0;                 // metres
  double z_near = 1.0, z_far = 0.0;  // light space: depth 1, depth 0
  int size = 1;                      // texels a side
  [[nodiscard]] double texel() const { return side / size; }
  bool operator==(const SunMap&) const = default;
};

// From the world's axes to light space (shading/cascades.glsl), its origin at the world's: to the right, down, towards
// the sun. They follow from the direction (unit) alone, so they never turn with the viewer.
[[nodiscard]] glm::dmat3 light_axes(const glm::dvec3& to_sun);

// Of the sun of a scene. Precondition: it has one.
[[nodiscard]] glm::dmat3 sun_axes(const upload::Tables& tables);

// A box of light space.
struct LightBox {
  glm::dvec3 low{0.0}, high{0.0};
};

// The extent of a box of the world. Precondition: it is not empty.
[[nodiscard]] LightBox light_box(const glm::dmat3& axes, const scene::WorldAabb& bounds);

// How far away blockers are told apart by their distance, metres: as far as there are any, `longest` at most.
[[nodiscard]] double blocker_distance(const LightBox& casters, double longest);

// To clip space, from the device's world space. origin: upload::Tables::origin.
[[nodiscard]] glm::mat4 clip_from_world(const SunMap& map, const glm::dvec3& origin);

// World-space planes, as an upload::Frustum's, of all casters that the map can see: the four sides and the far end.
// What stands towards the sun is never refused.
[[nodiscard]] std::vector<glm::dvec4> caster_planes(const SunMap& map);

// The widest penumbra of a map: a blocker that far towards the sun softens its edge over that radius.
struct Penumbra {
  double radius = 0.0, distance = 1.0;  // metres
};

// Of the sun of a scene, for blockers up to `distance` metres away, in a map of which half a side is `half_side`
// metres.
[[nodiscard]] Penumbra widest_penumbra(const upload::Tables& tables, bool soft, double distance, double half_side);

// As shaders read it.
[[nodiscard]] shading::Cascade gpu_cascade(const SunMap& map, const glm::dvec3& origin, const Penumbra& widest);

// How far vertices may move where a device draws them, pixels: half of what they snap to, on both axes.
[[nodiscard]] double vertex_snap(const gpu::Device& device);

// How casters are drawn into a map, between begin_rendering() and end_rendering() of its depth.
struct SunMapDraw {
  VkFormat depth_format = VK_FORMAT_UNDEFINED;
  upload::CasterChoice casters = upload::CasterChoice::all;
};

// Opaque casters and cutouts, of what the map sees, both sides of their surfaces. The depth bias is dynamic, and the
// caller's.
void draw_sun_map(graph::Context& c, const upload::Tables& tables, const SunMap& map, const SunMapDraw& how);

}  // namespace velarium::passes
