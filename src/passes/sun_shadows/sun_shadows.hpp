#pragma once

#include "graph/graph.hpp"
#include "passes/sun_shadows/cascade_fit.hpp"
#include "upload/scene_tables.hpp"

#include <velarium/settings.hpp>

#include <cstdint>
#include <vector>

namespace velarium::sun_shadows {

using Settings = velarium::Settings::sun_shadows_settings;

// Of a map's depth, and of its veils.
inline constexpr std::uint64_t kDepthBytes = 4, kVeilBytes = 8;  // a texel

// Which maps a picture has, whatever their size.
struct Demand {
  std::uint32_t maps = 0;  // 0 where a picture has no sun that casts shadows, or wants none
  bool whole = true;       // as Maps::hold_scene()
};
[[nodiscard]] Demand demand(const upload::SceneTables& scene, const upload::ViewMatrices& view,
                            const Settings& settings);

// The maps of the sun of one picture after the other, some of which may be kept (MapUpdate::staggered); none where a
// picture has no sun that casts shadows, or wants none.
class Maps {
 public:
  // Fits maps to a picture, before its first frame, and fills SceneTables::host_sun_shadows. Throws Error(usage) where
  // the device has no images of settings.size.
  void fit(gpu::Device& device, upload::SceneTables& scene, const upload::ViewMatrices& view, const Settings& settings);

  [[nodiscard]] bool empty() const { return maps_.empty(); }
  // Is every surface that can be seen in one of the maps? Else far_shadows has to help.
  [[nodiscard]] bool hold_scene() const { return hold_scene_; }
  [[nodiscard]] const std::vector<Map>& maps() const { return maps_; }
  // Is a map to be drawn in the first frame of this picture?
  [[nodiscard]] bool is_stale(std::size_t map) const { return stale_[map]; }
  // Do BLEND surfaces stand in a map's way of light, as it was drawn last?
  [[nodiscard]] bool is_veiled(std::size_t map) const { return veiled_[map]; }
  // One layer a map, D32F; of one texel where there are none. Precondition: fit() was called.
  [[nodiscard]] gpu::Image& depths() { return depths_; }
  // The same size, RGBA16F (shading/translucency.glsl); null where no map is veiled.
  [[nodiscard]] gpu::Image& veils() { return veils_; }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }

 private:
  // What all maps of a picture share. Maps of another are of no use.
  struct Shared {
    std::uint64_t scene_id = 0;
    std::size_t casters = 0;
    glm::dmat3 axes{1.0};
    int size = 0;
    std::size_t maps = 0;
    float slope_bias = 0.0f;
    bool translucent = false;
    bool operator==(const Shared&) const = default;
  };
  [[nodiscard]] shading::SunShadows fit_all(const upload::SceneTables& scene, const View& view,
                                            const Settings& settings);
  // size: texels a side.
  void allocate(gpu::Device& device, std::uint32_t size);
  void note_veils(const upload::CasterTable& casters, shading::SunShadows& table);

  std::vector<Map> maps_;
  std::vector<bool> stale_, veiled_;  // by map
  Shared shared_;
  bool hold_scene_ = true;
  std::uint64_t pictures_ = 0;  // since all maps were drawn
  glm::dvec3 eye_{0.0};
  gpu::Image depths_, veils_;
};

struct Inputs {
  const upload::SceneTables& scene;
  Maps& maps;
  bool first = true;  // is this the first frame of the picture? The others read what it drew
  float slope_bias = 1.0f;
};

struct Outputs {
  graph::GraphImage depths;
  graph::GraphImage veils;  // version 0 where nothing translucent stands in the sun's light
};

// Draws the maps.
[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::sun_shadows
