#pragma once

// Everything that a lit point reads: passes/illumination.glsl. A technique that lights points, or keeps light from
// them, adds a member here, and none of the passes that shade changes.

#include "passes/ambient_lights/read.hpp"
#include "passes/area_lights/read.hpp"
#include "passes/clip_volumes/read.hpp"
#include "passes/environment/read.hpp"
#include "passes/far_shadows/read.hpp"
#include "passes/frame_scene.hpp"
#include "passes/local_shadows/read.hpp"
#include "passes/projectors/read.hpp"
#include "passes/sun_shadow_mask/read.hpp"
#include "passes/sun_shadows/read.hpp"

#include <velarium/settings.hpp>

namespace velarium::passes {

struct Illumination {
  FrameScene scene;
  ShadingModel model = ShadingModel::gltf;
  bool multi_scatter = true;
  environment::Reading environment;
  ambient_lights::Reading ambient_lights;
  area_lights::Reading area_lights;
  projectors::Reading projectors;
  clip_volumes::Reading clip_volumes;
  sun_shadows::Reading sun;
  far_shadows::Reading far;
  sun_shadow_mask::Reading sun_shadow_mask;
  local_shadows::Reading local;
};

// Calls f with each technique's reading.
template <class F>
void each(const Illumination& in, F f) {
  f(in.environment);
  f(in.ambient_lights);
  f(in.area_lights);
  f(in.projectors);
  f(in.clip_volumes);
  f(in.sun);
  f(in.far);
  f(in.sun_shadow_mask);
  f(in.local);
}

// Declares that a pass reads, in this way, what earlier passes made of these.
void declare(graph::Pass& pass, const Illumination& in, graph::Access access);
// Binds descriptor set 1, but for the light lists of forward surfaces.
void bind(graph::SetWriter& set, const Illumination& in);
[[nodiscard]] gpu::Specialization specialization(const Illumination& in);

// Turns of loops that one lit point may take under so many punctual lights: software drivers bound those of a thread.
[[nodiscard]] std::uint64_t loop_iterations(const Illumination& in, std::uint64_t lights);

}  // namespace velarium::passes
