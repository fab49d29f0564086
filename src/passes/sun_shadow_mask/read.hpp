#pragma once

#include "passes/io.hpp"

namespace velarium::sun_shadow_mask {

namespace io {
using namespace shading;
#include "passes/sun_shadow_mask/sun_shadow_mask_io.glsl"
}  // namespace io

// The mask as deferred passes read it. Passes over other surfaces look the sun's maps up themselves: theirs has none.
struct Reading {
  graph::GraphImage mask;  // R32F, by pixel: the share of the sun that is hidden; version 0: there is none
};

inline void declare(graph::Pass& pass, const Reading& in, graph::Access access) {
  if (in.mask.version != 0) pass.read(in.mask, access);
}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.sampled(io::sun_shadow_mask, in.mask);
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kSunShadowMask, in.mask.version != 0);
}

}  // namespace velarium::sun_shadow_mask
