#pragma once

#include "passes/io.hpp"

#include <velarium/settings.hpp>

namespace velarium::far_shadows {

namespace io {
using namespace shading;
#include "passes/far_shadows/far_shadows_io.glsl"
}  // namespace io

static_assert(static_cast<std::uint32_t>(FarShadow::off) == io::kNoFarShadow);
static_assert(static_cast<std::uint32_t>(FarShadow::vsm) == io::kFarVariance);
static_assert(static_cast<std::uint32_t>(FarShadow::static_map) == io::kFarStatic);

// The far map as lit points read it.
struct Reading {
  FarShadow kind = FarShadow::off;
  graph::GraphImage map;     // vsm: two layers, mean and mean square of depth; static_map: depth. Version 0: off
  graph::GraphBuffer table;  // io::FarCascade
};

inline void declare(graph::Pass& pass, const Reading& in, graph::Access access) {
  if (in.map.version != 0) pass.read(in.map, access);
}
inline void bind(graph::SetWriter& set, const Reading& in) {
  const graph::GraphImage none;
  set.sampled(io::far_moments, in.kind == FarShadow::vsm ? in.map : none)
      .sampled(io::far_depths, in.kind == FarShadow::static_map ? in.map : none)
      .buffer(io::FarBuffer, in.table);
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kFarShadow, static_cast<std::uint32_t>(in.kind));
}

}  // namespace velarium::far_shadows
