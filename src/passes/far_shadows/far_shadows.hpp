#pragma once

#include "graph/graph.hpp"
#include "passes/sun_map.hpp"
#include "upload/gpu_scene.hpp"

#include <velarium/settings.hpp>

#include <cstdint>

namespace velarium::far_shadows {

using Settings = velarium::Settings::sun_shadows_settings;

// The box of light space that a map of everything in `casters` sees: as tight as it can be. guard: texels around it.
[[nodiscard]] passes::SunMap fit_to(const glm::dmat3& axes, const passes::LightBox& casters, int size, double guard);

// `wanted`, halved until a square of it, of so many bytes a texel, takes no more than the memory, MiB, and images may
// be as large.
[[nodiscard]] int affordable_size(int wanted, int texel_bytes, int memory_mib, std::uint32_t largest_image);

// One map of the whole scene, of one picture after the other. That of what never moves may be kept, where pictures keep
// maps (MapUpdate::staggered).
class Map {
 public:
  // Fits the map to a picture, before its first frame, and fills SceneTables::host_sun_shadows.beyond. wanted: is there
  // a sun, and do its other maps leave something of the scene? Without, the map's memory is given back.
  void fit(gpu::Device& device, upload::SceneTables& scene, const glm::dvec3& eye, bool wanted,
           const Settings& settings);

  [[nodiscard]] FarSun kind() const { return kind_; }
  // Has it fewer texels than the settings ask for, as memory or the device has no more?
  [[nodiscard]] bool is_reduced() const { return map_.size < wanted_size_; }
  // Is it to be drawn in the first frame of this picture?
  [[nodiscard]] bool is_stale() const { return stale_; }
  // As passes::FarSunMap has it. Precondition: kind() is not off.
  [[nodiscard]] gpu::Image& image() { return image_; }
  [[nodiscard]] const passes::SunMap& map() const { return map_; }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] float blur_deviation() const { return blur_deviation_; }  // texels

 private:
  void fit_moments(gpu::Device& device, upload::SceneTables& scene, const Settings& settings);
  void fit_static(gpu::Device& device, upload::SceneTables& scene, const Settings& settings);
  void allocate(gpu::Device& device, const gpu::ImageDesc& desc, VkImageUsageFlags usage);

  FarSun kind_ = FarSun::off;
  bool stale_ = false;
  passes::SunMap map_;
  int wanted_size_ = 0;  // texels
  // What a kept map was drawn of.
  std::uint64_t scene_id_ = 0;
  float slope_bias_ = 0.0f;
  float blur_deviation_ = 0.0f;
  glm::dvec3 eye_{0.0};
  gpu::Image image_;
};

struct Inputs {
  const upload::SceneTables& scene;
  Map& map;
  bool first = true;  // is this the first frame of the picture? The others read what it drew
  float slope_bias = 1.0f;
};

// Draws the map, and blurs it where it is one of moments.
[[nodiscard]] passes::FarSunMap add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::far_shadows
