#pragma once

#include "passes/map_demand.hpp"
#include "passes/sun_shadows/cascade_fit.hpp"
#include "upload/view.hpp"

#include <velarium/engine.hpp>
#include <velarium/settings.hpp>

#include <cstdint>
#include <vector>

namespace velarium::sun_shadows {

using Settings = velarium::Settings::sun_shadows_settings;

// The maps of the sun of one picture after the other, some of which may be kept (MapUpdate::staggered); none where a
// picture has no sun that casts shadows, or wants none.
class State {
 public:
  // Fits maps to a picture, before its first frame. static_map: does one hold all that never moves, and take the place
  // of the last cascades? Throws Error(usage) where the device has no images of
  // settings.size.
  void prepare(gpu::Device& device, const upload::Tables& tables, const upload::ViewMatrices& view,
               const Settings& settings, bool static_map);

  [[nodiscard]] bool empty() const { return maps_.empty(); }
  // Is every surface that can be seen in one of the maps? Else a far map has to help.
  [[nodiscard]] bool hold_scene() const { return hold_scene_; }
  [[nodiscard]] const std::vector<Map>& maps() const { return maps_; }
  // Is a map to be drawn in the first frame of this picture?
  [[nodiscard]] bool is_stale(std::size_t map) const { return stale_[map]; }
  // Do BLEND surfaces stand in a map's way of light, as it was drawn last?
  [[nodiscard]] bool is_translucent(std::size_t map) const { return translucent_[map]; }
  // One layer a map, D32F; null where there are none.
  [[nodiscard]] gpu::Image& depths() { return depths_; }
  // The same size, RGBA16F (shading/translucency.glsl); null where no map needs it.
  [[nodiscard]] gpu::Image& translucency() { return translucency_; }
  // What shaders know of the maps.
  [[nodiscard]] const shading::SunShadows& table() const { return table_; }
  [[nodiscard]] std::vector<MapMemory> memory() const;

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
  void fit_all(const upload::Tables& tables, const View& view, const Settings& settings, bool static_map);
  void allocate(gpu::Device& device, std::uint32_t size);
  void note_translucency(const upload::CasterTable& casters);

  std::vector<Map> maps_;
  std::vector<bool> stale_, translucent_;  // by map
  Shared shared_;
  bool hold_scene_ = true;
  std::uint64_t pictures_ = 0;  // since all maps were drawn
  shading::SunShadows table_{};
  gpu::Image depths_, translucency_;
};

// Which maps a picture will have, whatever their size.
struct Demand {
  passes::MapDemand maps;
  bool any = false;
  bool whole = true;  // as State::hold_scene()
};
[[nodiscard]] Demand demand(const upload::Tables& tables, const upload::ViewMatrices& view, const Settings& settings,
                            bool static_map);

}  // namespace velarium::sun_shadows
