#include "frame/frame.hpp"

#include "frame/shadow_memory.hpp"
#include "passes/accumulate/accumulate.hpp"
#include "passes/ambient_lights/ambient_lights.hpp"
#include "passes/area_lights/area_lights.hpp"
#include "passes/contact_shadows/contact_shadows.hpp"
#include "passes/display/display.hpp"
#include "passes/environment/environment.hpp"
#include "passes/exposure/exposure.hpp"
#include "passes/far_shadows/far_shadows.hpp"
#include "passes/forward/forward.hpp"
#include "passes/gbuffer/gbuffer.hpp"
#include "passes/illumination.hpp"
#include "passes/light_volumes/light_volumes.hpp"
#include "passes/lighting/lighting.hpp"
#include "passes/local_shadows/local_shadows.hpp"
#include "passes/specular_aa/specular_aa.hpp"
#include "passes/sun_shadow_mask/sun_shadow_mask.hpp"
#include "passes/sun_shadows/sun_shadows.hpp"

#include <algorithm>

namespace velarium::frame {
namespace {

far_shadows::Settings far_settings(const Settings& settings) {
  const auto& sun = settings.sun_shadows;
  return {.kind = settings.far_shadows.kind,
          .size = settings.far_shadows.size,
          .static_size = settings.far_shadows.static_size,
          .soft = sun.soft,
          .max_blocker_distance = sun.max_blocker_distance,
          .normal_offset = sun.normal_offset,
          .slope_bias = sun.slope_bias,
          .update = sun.update};
}

bool has_static_map(const upload::Tables& tables, const Settings& settings) {
  return far_shadows::possible_kind(settings.far_shadows.kind, tables.casters) == FarShadow::static_map;
}

// The settings, with maps as large as shadows.memory allows. Of equals, first the far map is made smaller, then the
// atlas of points and spots, then the cascades.
Prepared fit_shadow_maps(const upload::Tables& tables, const upload::View& view, const Settings& wanted) {
  const auto sun = sun_shadows::demand(tables, view.matrices, wanted.sun_shadows, has_static_map(tables, wanted));
  // Far maps that are kept over several pictures stay where a picture does not need them.
  const bool far = !sun.whole || wanted.sun_shadows.update == MapUpdate::staggered;
  const auto kind = far ? far_shadows::possible_kind(wanted.far_shadows.kind, tables.casters) : FarShadow::off;
  const std::array demands{far_shadows::demand(kind, far_settings(wanted)),
                           local_shadows::demand(tables, wanted.local_shadows), sun.maps};
  const std::uint64_t mask_bytes = sun.any ? sun_shadow_mask::mask_bytes(view.size) : 0;
  const auto fitted = fit_to_budget(demands, mask_bytes, wanted.shadows.memory);

  Prepared prepared{.settings = wanted};
  auto& settings = prepared.settings;
  (kind == FarShadow::static_map ? settings.far_shadows.static_size : settings.far_shadows.size) =
      fitted.demands[0].side;
  settings.local_shadows.atlas = fitted.demands[1].side;
  settings.sun_shadows.size = fitted.demands[2].side;
  prepared.notes.push_back(fitted.note);
  return prepared;
}

environment::Reading add_environment(graph::Graph& g, const FrameInputs& in) {
  const auto* baked = in.environment;
  const bool is_background = in.background == Background::environment;
  environment::Inputs inputs{.brdf_table = &in.brdf_table,
                             .shown = is_background && baked != nullptr,
                             // Without an environment to show, the background of that name is black and opaque.
                             .color = glm::vec4(0.0f, 0.0f, 0.0f, is_background ? 1.0f : 0.0f),
                             .occlusion = in.settings.lighting.occlusion};
  if (baked != nullptr) {
    inputs.background = &baked->background;
    inputs.lobes = &baked->specular;
    inputs.irradiance = &baked->irradiance;
    inputs.sh = baked->sh;
  }
  return environment::add(g, inputs, in.settings.environment);
}

}  // namespace

Prepared prepare(State& state, gpu::Device& device, const upload::Tables& tables, const upload::View& view,
                 const Settings& wanted) {
  auto prepared = fit_shadow_maps(tables, view, wanted);
  const auto& s = prepared.settings;
  state.local_shadows.prepare(device, tables, {view.matrices, view.size, tables.origin}, s.local_shadows);
  state.sun_shadows.prepare(device, tables, view.matrices, s.sun_shadows, has_static_map(tables, s));
  const bool far = !state.sun_shadows.empty() && !state.sun_shadows.hold_scene();
  state.far_shadows.prepare(device, tables, far, far_settings(s));

  prepared.notes.push_back(state.local_shadows.note());
  prepared.notes.push_back(state.far_shadows.note());
  std::erase(prepared.notes, std::string());
  return prepared;
}

std::vector<MapMemory> shadow_maps(const State& state, std::span<const graph::KeptImage> images) {
  std::vector<MapMemory> maps;
  for (const auto& held : {state.sun_shadows.memory(), state.far_shadows.memory(), state.local_shadows.memory()})
    maps.insert(maps.end(), held.begin(), held.end());
  std::erase_if(maps, [](const MapMemory& map) { return map.bytes == 0; });
  for (const auto& image : images)
    if (image.name == sun_shadow_mask::kMask ||
        std::ranges::find(far_shadows::kSteps, image.name) != far_shadows::kSteps.end())
      maps.push_back({image.name, image.bytes});
  return maps;
}

graph::GraphImage add_frame(graph::Graph& g, const FrameInputs& in) {
  const auto& s = in.settings;
  const auto scene = passes::frame_scene(g, in.tables, in.view, in.sample);
  const auto drawn = gbuffer::add(g, {scene, in.normal_lengths, s.specular_aa.baked});
  auto surfaces = drawn.gbuffer;
  surfaces.specular = specular_aa::add(g, {scene, drawn.gbuffer}, s.specular_aa);

  passes::Illumination light{.scene = scene,
                             .model = s.lighting.model,
                             .multi_scatter = s.lighting.multi_scatter,
                             .environment = add_environment(g, in),
                             .ambient_lights = ambient_lights::add(g, in.tables, in.view.matrices, s.ambient_lights),
                             .area_lights = area_lights::add(g, in.tables, s.lighting),
                             .projectors = projectors::reading(in.tables),
                             .clip_volumes = clip_volumes::reading(in.tables)};
  light.local = local_shadows::add(g, {in.tables, in.state.local_shadows, in.first, s.local_shadows});
  light.sun = sun_shadows::add(g, {in.tables, in.state.sun_shadows, in.first, s.sun_shadows});
  light.far = far_shadows::add(g, {in.tables, in.state.far_shadows, in.first, far_settings(s)});
  const auto contact = contact_shadows::add(g, light.local.atlas.version != 0, s.contact_shadows);

  auto masked = light;  // what opaque surfaces read
  if (!in.state.sun_shadows.empty())
    masked.sun_shadow_mask = sun_shadow_mask::add(g, {light, contact.sun, surfaces.normal, surfaces.depth});
  graph::GraphImage volume_light;
  if (s.lighting.path == LightingPath::volumes) volume_light = light_volumes::add(g, {masked, surfaces});
  const auto lit = lighting::add(g, {masked, contact.local, surfaces, drawn.hdr, s.lighting.path, volume_light});
  const auto hdr = forward::add(g, {light, s.specular_aa.baked, surfaces.depth, lit.hdr, lit.forward_lists});
  return accumulate::add(g, {hdr, g.import("sum", in.sum, !in.first), in.first});
}

DisplayOutputs add_display(graph::Graph& g, const DisplayInputs& in) {
  const auto& s = in.settings;
  const auto sum = g.import("sum", in.sum, true);
  DisplayOutputs out;
  if (in.want_linear) out.linear = display::linear_readback(g, sum, in.frames);
  if (in.want_display) {
    const auto exposure = exposure::add(g, {sum, in.frames}, s.display);
    out.display = display::add(g, {sum, exposure.exposure, in.frames},
                               {.tonemap = s.display.tonemap,
                                .bits = s.output.bits,
                                .dither = s.display.dither,
                                .seed = static_cast<std::uint32_t>(s.frame.seed),
                                .background = in.background});
  }
  return out;
}

}  // namespace velarium::frame
