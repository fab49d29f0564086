#pragma once

#include "passes/far_shadows/read.hpp"
#include "passes/map_demand.hpp"
#include "passes/sun_map.hpp"

#include <velarium/engine.hpp>
#include <velarium/settings.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace velarium::far_shadows {

struct Settings {
  FarShadow kind = FarShadow::vsm;
  int size = 2048, static_size = 8192;  // texels, of a map of moments and of a static one
  bool soft = true;
  float max_blocker_distance = 100.0f;  // metres
  float normal_offset = 0.5f;           // texels
  float slope_bias = 0.5f;              // texels
  MapUpdate update = MapUpdate::all;
};

// The box of light space that a map of everything in `casters` sees: as tight as it can be. guard: texels around it.
[[nodiscard]] passes::SunMap fit_to(const glm::dmat3& axes, const passes::LightBox& casters, int size, double guard);

// `wanted`, but for a static map where all casters move: there is nothing to put into it.
[[nodiscard]] FarShadow possible_kind(FarShadow wanted, const upload::CasterTable& casters);

// `wanted`, halved until images may be as large.
[[nodiscard]] int possible_size(int wanted, std::uint32_t largest_image);

// One map of the whole scene, of one picture after the other. Where pictures keep maps (MapUpdate::staggered), that of
// what never moves is kept as long as it can be, that of moments for some pictures.
class State {
 public:
  // Fits the map to a picture, before its first frame. wanted: is there a sun, and do its other maps leave something of
  // the scene? Without, the map's memory is given back, but where pictures keep maps: the next view may want it again.
  void prepare(gpu::Device& device, const upload::Tables& tables, bool wanted, const Settings& settings);

  [[nodiscard]] FarShadow kind() const { return kind_; }
  // A sentence where the map has fewer texels than the settings ask for, as the device's images are no larger.
  [[nodiscard]] std::string note() const;
  // Is it to be drawn in the first frame of this picture?
  [[nodiscard]] bool is_stale() const { return stale_; }
  // As Reading::map; null where none is held.
  [[nodiscard]] gpu::Image& image() { return image_; }
  [[nodiscard]] const passes::SunMap& map() const { return contents_.map; }
  [[nodiscard]] float blur_deviation() const { return contents_.blur_deviation; }  // texels
  [[nodiscard]] const io::FarCascade& table() const { return table_; }
  [[nodiscard]] std::vector<MapMemory> memory() const;

 private:
  // What a map shows. One of something else is of no use.
  struct Contents {
    std::uint64_t scene_id = 0;
    passes::SunMap map;
    float slope_bias = 0.0f, blur_deviation = 0.0f;
    bool operator==(const Contents&) const = default;
  };
  void keep_or_draw(const Contents& contents, bool may_keep);
  void fit_moments(gpu::Device& device, const upload::Tables& tables, const Settings& settings);
  void fit_static(gpu::Device& device, const upload::Tables& tables, const Settings& settings);
  void allocate(gpu::Device& device, const gpu::ImageDesc& desc, VkImageUsageFlags usage);

  FarShadow kind_ = FarShadow::off;
  bool stale_ = false;
  int age_ = 0;          // pictures since it was drawn
  int wanted_size_ = 0;  // texels
  Contents contents_;
  io::FarCascade table_{};
  gpu::Image image_;
};

// kind: possible_kind(), or off where the cascades hold all that is seen.
[[nodiscard]] passes::MapDemand demand(FarShadow kind, const Settings& settings);

}  // namespace velarium::far_shadows
