#pragma once

// What rays hit, by Embree.

#include "reference/materials.hpp"
#include "reference/objects.hpp"

#include <glm/vec3.hpp>

#include <embree3/rtcore.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace velarium::reference {

struct Ray {
  glm::vec3 origin{0.0f}, direction{0.0f};                         // unit
  float from = 0.0f, to = std::numeric_limits<float>::infinity();  // metres along it
  // The pixel's cone, for the mips that decide about transparency: its width at the origin, and what it gains a metre.
  float cone_width_m = 0.0f, cone_spread = 0.0f;
  // Transparency is a matter of chance: equal numbers give equal fates, whatever the order in which triangles are met.
  std::uint32_t chance = 0;
  bool skip_back_faces = false;  // of materials that are not double-sided, as the rasteriser does

  [[nodiscard]] float cone_at(float distance) const { return cone_width_m + cone_spread * distance; }
};

// Blended triangles that a ray went through, in no order, and some perhaps behind what stopped it.
struct TransparentHits {
  struct One {
    float distance;
    glm::vec3 tint;
  };
  std::vector<One> passed;

  // What multiplies light that comes from this far.
  [[nodiscard]] glm::vec3 tint_before(float distance) const;
};

struct Found {
  std::optional<Hit> hit;
  TransparentHits transparent;
};

// Triangles in a hierarchy of boxes. Equal scenes give equal hits, whatever the number of threads.
class Geometry {
 public:
  // Both must outlive this. Throws Error(temporary) where memory runs out.
  Geometry(const std::vector<Object>& objects, const Materials& materials);
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  // The nearest triangle that stops the ray.
  [[nodiscard]] Found closest(const Ray& ray) const;
  // What multiplies light that comes along the whole ray: 0 where any triangle stops it.
  [[nodiscard]] glm::vec3 transmitted(const Ray& ray) const;

 private:
  struct Context;
  struct Releaser {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  using SceneOwner = std::unique_ptr<RTCSceneTy, Releaser>;

  void add_flat(RTCScene scene, std::uint32_t object, unsigned id);
  void add_instance(RTCScene mesh, std::uint32_t object, unsigned id);
  void attach(RTCScene scene, RTCGeometry geometry, std::uint32_t material, unsigned id);
  [[nodiscard]] SceneOwner new_scene() const;
  void check(const char* doing) const;
  [[nodiscard]] bool lets_through(Context& context, std::uint32_t object, std::uint32_t triangle, float u, float v,
                                  float distance) const;
  static void filter_transparent(const RTCFilterFunctionNArguments* arguments);
  static void filter_back_faces(const RTCFilterFunctionNArguments* arguments);

  const std::vector<Object>& objects_;
  const Materials& materials_;
  std::unique_ptr<RTCDeviceTy, Releaser> device_;
  std::vector<SceneOwner> meshes_;  // of instances
  SceneOwner top_;
};

}  // namespace velarium::reference
