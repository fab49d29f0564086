#pragma once

#include "scene/snapshot.hpp"
#include "upload/gpu_structs.hpp"
#include "upload/triangle_order.hpp"

#include <array>
#include <span>
#include <vector>

namespace velarium::upload {

// One draw call: instances [first_object, first_object + object_count) of one primitive.
struct Draw {
  std::uint32_t primitive = 0;
  std::int32_t deformed = scene::kNone;
  std::uint32_t material = 0;  // into gpu_materials()
  std::uint32_t first_object = 0, object_count = 1;
  bool mirrored = false;
  std::int32_t first_sorted =
      scene::kNone;  // into DrawList::sorted_indices, of all of the primitive's; kNone: unsorted
};

// What a camera sees of a snapshot, ready to be drawn.
struct DrawList {
  std::vector<ObjectData> objects;            // by gl_InstanceIndex
  std::vector<Draw> opaque;                   // OPAQUE and MASK: by state, then near to far
  std::vector<Draw> blended;                  // BLEND: far to near
  std::vector<std::uint32_t> sorted_indices;  // of blended draws whose triangles are drawn far to near
};

// Planes of a view volume, world space, xyz inward normal; a point is inside where dot(n, p) + w >= 0 for all.
using Frustum = std::array<glm::dvec4, 5>;  // left, right, lower, upper, near

// `clip_from_world` in the scene's own world space.
[[nodiscard]] Frustum frustum_of(const glm::dmat4& clip_from_world);

// May a part of the box be inside all planes? Never wrong where it says no.
[[nodiscard]] bool overlaps(std::span<const glm::dvec4> planes, const scene::WorldAabb& box);

// What shaders know of an instance.
[[nodiscard]] ObjectData object_data(const scene::Instance& instance, const glm::dvec3& origin);

// Drops what is outside the frustum, sorts, joins neighbours that differ in their matrix alone, and makes matrices
// relative to `origin`. Of blended surfaces up to `sorted_triangles` are sorted one by one, the nearest objects first.
[[nodiscard]] DrawList make_draw_list(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                                      const glm::dvec3& origin, const Frustum& frustum, const Viewpoint& view,
                                      std::size_t sorted_triangles);

}  // namespace velarium::upload
