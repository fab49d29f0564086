#pragma once

// One path of light, from the eye backwards.

#include "reference/camera.hpp"
#include "reference/energy_table.hpp"
#include "reference/geometry.hpp"
#include "reference/lights.hpp"
#include "reference/materials.hpp"
#include "reference/sequence.hpp"

#include <cstdint>
#include <vector>

namespace velarium::reference {

// Which light is followed. docs/reference.md says what each stands for.
struct Transport {
  std::uint32_t reflections = 33;  // at most, along a path; at least 1
  bool environment = true;         // lights surfaces
  bool emissive_lighting = true;   // surfaces that glow light others
  bool shadows = true;
  float clamp = 0.0f;  // largest radiance that a path brings by two and more reflections; 0: any
  float min_highlight_alpha = shading::kMinAlphaPunctual;  // that points are reflected with
  std::uint32_t model = shading::kModelGltf;
  bool multi_scatter = true;
  bool background = true;         // the environment is seen where nothing is hit; else nothing is
  bool opaque_background = true;  // what is seen there counts as covered
  float sharpness = 1.0f;         // how many times finer than a pixel textures are read
};

// What a path through a pixel has found.
struct PathSample {
  glm::vec3 direct{0.0f};    // emission and background that are seen, and light reflected once; nits
  glm::vec3 indirect{0.0f};  // light reflected more often
  float alpha = 0.0f;        // 1: something was hit, or the background is opaque
  bool hit = false;
  glm::vec3 albedo{0.0f}, normal_ws{0.0f};  // of what was hit first
  float depth = 0.0f;                       // view depth of it, metres
};

// Everything that a path may meet.
struct World {
  const Camera& camera;
  const std::vector<Object>& objects;
  const Materials& materials;
  const Geometry& geometry;
  const Lights& lights;
  const EnergyTable& energy;
};

class PathTracer {
 public:
  // What `world` refers to must outlive this.
  PathTracer(const World& world, const Transport& transport, std::uint32_t seed)
      : world_(world), transport_(transport), seed_(seed) {}

  // A pure function of its arguments. Values that are not finite may come out where the scene's numbers overflow.
  [[nodiscard]] PathSample trace(glm::uvec2 pixel, std::uint32_t sample) const;

 private:
  struct Path;
  struct Vertex;
  struct Draws;

  void follow(Path& path) const;
  [[nodiscard]] Vertex vertex_at(const Path& path, const Hit& hit) const;
  void add_background(Path& path) const;
  void add_environment(Path& path) const;
  void add_spheres(Path& path, const TransparentHits& transparent, float distance) const;
  void add_emission(Path& path, const Hit& hit, const Vertex& vertex) const;
  void add_light(Path& path, const Vertex& vertex, const Draws& draws) const;
  [[nodiscard]] bool reflect(Path& path, const Vertex& vertex, const Draws& draws) const;
  [[nodiscard]] glm::vec3 arriving(const Path& path, const Vertex& vertex, const LightSample& light) const;
  [[nodiscard]] bool anything_to_find(const Path& path) const;

  World world_;
  Transport transport_;
  std::uint32_t seed_;
};

}  // namespace velarium::reference
