#include "frame/frame.hpp"

#include "passes/accumulate/accumulate.hpp"
#include "passes/display/display.hpp"
#include "passes/exposure/exposure.hpp"
#include "passes/forward/forward.hpp"
#include "passes/gbuffer/gbuffer.hpp"
#include "passes/light_volumes/light_volumes.hpp"
#include "passes/lighting/lighting.hpp"
#include "passes/normal_variance/normal_variance.hpp"
#include "passes/sun_mask/sun_mask.hpp"

namespace velarium::frame {

graph::GraphImage add_frame(graph::Graph& g, const FrameInputs& in) {
  const auto drawn = gbuffer::add(g, {in.scene, in.normal_lengths, in.width, in.height});
  const auto rt2 = normal_variance::add(g, {in.scene, drawn.rt0, drawn.rt2, drawn.depth}, in.settings.specular_aa);
  const passes::GBuffer surface{drawn.rt0, drawn.rt1, rt2, drawn.depth};
  const auto local = local_shadows::add(g, {in.scene, in.local_shadows, in.first}, in.settings.local_shadows);
  const auto& sun_settings = in.settings.sun_shadows;
  const auto sun = sun_shadows::add(g, {in.scene, in.sun_maps, in.first, sun_settings.slope_bias});
  const auto far = far_shadows::add(g, {in.scene, in.far_map, in.first, sun_settings.slope_bias});
  graph::GraphImage sun_mask;
  if (!in.sun_maps.empty())
    sun_mask = sun_mask::add(g, {in.scene, surface.rt0, surface.depth, sun.depths, far}, in.settings);
  const passes::ShadingInputs shading{.scene = in.scene,
                                      .environment = in.environment,
                                      .settings = in.settings,
                                      .no_map = in.no_map,
                                      .shadow_atlas = local.atlas,
                                      .sun_cascades = sun.depths,
                                      .sun_far = far,
                                      .sun_mask = sun_mask,
                                      .shadow_veils = local.veils,
                                      .sun_veils = sun.veils};
  graph::GraphImage lamps;
  if (in.settings.lighting.path == LightingPath::volumes) lamps = light_volumes::add(g, {shading, surface});
  const auto lit = lighting::add(g, {shading, surface, drawn.hdr, lamps});
  const auto hdr = forward::add(g, {shading, surface.depth, lit.hdr, lit.forward_lists});
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
