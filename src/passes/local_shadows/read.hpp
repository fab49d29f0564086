#pragma once

#include "passes/io.hpp"

namespace velarium::local_shadows {

namespace io {
using namespace shading;
#include "passes/local_shadows/local_shadows_io.glsl"
}  // namespace io

// The maps of point and spot lights as lit points read them. Everything has version 0 where no light has a map.
struct Reading {
  graph::GraphImage atlas;               // all views side by side, reversed depth
  graph::GraphImage translucency;        // beside it; version 0 where no BLEND surface stands in a light's way
  graph::GraphBuffer views, first_view;  // shading::ShadowView, io::LightShadowBuffer
  std::uint32_t taps = 0;                // 0: no light has a map; 1: all that have one are points
};

inline void declare(graph::Pass& pass, const Reading& in, graph::Access access) {
  for (const auto image : {in.atlas, in.translucency})
    if (image.version != 0) pass.read(image, access);
}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.sampled(io::shadow_atlas, in.atlas)
      .sampled(io::local_translucency, in.translucency)
      .buffer(io::ShadowViewBuffer, in.views)
      .buffer(io::LightShadowBuffer, in.first_view);
}
// Search, layers, filter; half as many taps find and filter what dyes light. Points read a texel of each.
inline std::uint64_t loop_iterations(const Reading& in) {
  if (in.taps == 0) return 0;
  return in.taps > 1 ? 4 * std::uint64_t{in.taps} : 2;
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kLocalShadowTaps, in.taps).set(io::kLocalTranslucency, in.translucency.version != 0);
}

}  // namespace velarium::local_shadows
