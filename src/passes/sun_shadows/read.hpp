#pragma once

#include "passes/io.hpp"

namespace velarium::sun_shadows {

namespace io {
using namespace shading;
#include "passes/sun_map_io.glsl"
#include "passes/sun_shadows/sun_shadows_io.glsl"
}  // namespace io

// The cascades as lit points read them. Everything has version 0 where no sun casts shadows.
struct Reading {
  graph::GraphImage depths;  // a layer a cascade, reversed depth
  graph::GraphImage
      translucency;          // the same, shading/translucency.glsl; version 0 where no BLEND surface stands in them
  graph::GraphBuffer table;  // shading::SunShadows
  std::uint32_t taps = 32;   // of the widest penumbra; even
};

inline void declare(graph::Pass& pass, const Reading& in, graph::Access access) {
  for (const auto image : {in.depths, in.translucency})
    if (image.version != 0) pass.read(image, access);
}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.sampled(io::sun_depths, in.depths).sampled(io::sun_translucency, in.translucency).buffer(io::SunBuffer, in.table);
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kSunShadows, in.depths.version != 0)
      .set(io::kSunTranslucency, in.translucency.version != 0)
      .set(io::kSunShadowTaps, in.taps);
}

}  // namespace velarium::sun_shadows
