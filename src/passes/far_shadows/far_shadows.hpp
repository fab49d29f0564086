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

// Of a map while it is drawn, with what it is made of and blurred through.
[[nodiscard]] std::uint64_t texel_bytes(FarSun kind);

// `wanted`, but for a static map where all casters move: there is nothing to put into it.
[[nodiscard]] FarSun possible_kind(FarSun wanted, const upload::CasterTable& casters);

// `wanted`, halved until images may be as large.
[[nodiscard]] int possible_size(int wanted, std::uint32_t largest_image);

// One map of the whole scene, of one picture after the other. Where pictures keep maps (MapUpdate::staggered), that of
// what never moves is kept as long as it can be, that of moments for some pictures.
class Map {
 public:
  // Fits the map to a picture, before its first frame, and fills SceneTables::host_sun_shadows.beyond. wanted: is there
  // a sun, and do its other maps leave something of the scene? Without, the map's memory is given back, but where
  // pictures keep maps: the next view may want it again.
  void fit(gpu::Device& device, upload::SceneTables& scene, const glm::dvec3& eye, bool wanted,
           const Settings& settings);

  [[nodiscard]] FarSun kind() const { return kind_; }
  // Has it fewer texels than the settings ask for, as the device's images are no larger?
  [[nodiscard]] bool is_reduced() const { return contents_.map.size < wanted_size_; }
  // Is it to be drawn in the first frame of this picture?
  [[nodiscard]] bool is_stale() const { return stale_; }
  // As passes::FarSunMap has it; null where none is held.
  [[nodiscard]] gpu::Image& image() { return image_; }
  [[nodiscard]] const passes::SunMap& map() const { return contents_.map; }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] float blur_deviation() const { return contents_.blur_deviation; }  // texels

 private:
  // What a map shows. One of something else is of no use.
  struct Contents {
    std::uint64_t scene_id = 0;
    passes::SunMap map;
    float slope_bias = 0.0f, blur_deviation = 0.0f;
    bool operator==(const Contents&) const = default;
  };
  void keep_or_draw(const Contents& contents, bool may_keep);
  void fit_moments(gpu::Device& device, upload::SceneTables& scene, const Settings& settings);
  void fit_static(gpu::Device& device, upload::SceneTables& scene, const Settings& settings);
  void allocate(gpu::Device& device, const gpu::ImageDesc& desc, VkImageUsageFlags usage);

  FarSun kind_ = FarSun::off;
  bool stale_ = false;
  int age_ = 0;          // pictures since it was drawn
  int wanted_size_ = 0;  // texels
  Contents contents_;
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
