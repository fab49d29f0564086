#pragma once

// The triangles of a snapshot as rays meet them. World space has the scene's axes and its origin at the eye, as on the
// device (docs/conventions.md).

#include "scene/snapshot.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace velarium::reference {

// A place on a triangle: barycentric weights of its second and third corner.
struct Hit {
  std::uint32_t object = 0, triangle = 0;
  float u = 0.0f, v = 0.0f;
  float distance = 0.0f;  // along the ray, metres
};

// One instance of a triangle mesh. Refers to the scene and the snapshot, which must outlive it.
struct Object {
  const scene::Primitive* primitive = nullptr;
  const scene::VertexFrames* vertices = nullptr;  // the deformed ones where there are such
  glm::mat3 turn{1.0f};                           // world from object, without the translation
  glm::vec3 place{0.0f};
  glm::mat3 cofactors{1.0f};   // takes normals
  float handedness = 1.0f;     // -1: mirrored, front faces are clockwise
  float inverse_scale = 0.0f;  // of a transform that only turns, moves and scales evenly; 0 for others
  std::uint32_t material = 0;  // index into Scene::materials; their number: the default material
  std::uint32_t mesh = 0;      // the same for objects that share their vertices

  [[nodiscard]] std::uint32_t triangle_count() const {
    return static_cast<std::uint32_t>(primitive->indices.size() / 3);
  }
  [[nodiscard]] std::array<std::uint32_t, 3> corners(std::uint32_t triangle) const;
  [[nodiscard]] glm::vec3 position_ws(std::uint32_t vertex) const { return turn * vertices->positions[vertex] + place; }
  [[nodiscard]] std::array<glm::vec3, 3> positions_ws(std::uint32_t triangle) const;
};

// The triangle meshes of the snapshot relative to `eye`, in the order of its instances; points and lines are left out.
[[nodiscard]] std::vector<Object> objects_of(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                                             const glm::dvec3& eye);

// What is interpolated at a hit, as the rasteriser hands it to the material.
struct SurfacePoint {
  const Object* object = nullptr;
  std::array<std::uint32_t, 3> corners{};
  std::array<float, 3> weights{};
  glm::vec3 position_ws{0.0f};
  glm::vec3 geometric_normal_ws{0.0f};  // unit, of the front side
  float area_m2 = 0.0f;                 // of the triangle
  float rounding_m = 0.0f;              // how far position_ws may be from the triangle

  [[nodiscard]] glm::vec3 normal_ws() const;   // not unit
  [[nodiscard]] glm::vec4 tangent_ws() const;  // xyz null where there is none; w: sign of the bitangent
  [[nodiscard]] glm::vec4 color() const;
  [[nodiscard]] glm::vec2 uv(std::uint32_t set) const;
  // log2 of how far a width on the surface reaches in texture coordinates: the root of both axes. The width across the
  // ray is the shorter side of its footprint where it falls slantwise: what is sharper than the longer one is averaged
  // by the paths of the pixel.
  [[nodiscard]] float log2_uv(std::uint32_t set, float width_m) const;
};

[[nodiscard]] SurfacePoint surface_point(const Object& object, std::uint32_t triangle, float u, float v);

}  // namespace velarium::reference
