#pragma once

#include "passes/io.hpp"
#include "upload/tables.hpp"

namespace velarium::projectors {

namespace io {
using namespace shading;
#include "passes/projectors/projectors_io.glsl"
}  // namespace io

// Pictures that spot lights throw, as lit points read them.
struct Reading {
  const gpu::Image& pictures;  // a layer each; outlives the frame
  float lod_bias = 0.0f;
  bool any = false;  // does some light throw one?
};

[[nodiscard]] inline Reading reading(const upload::Tables& tables) {
  return {tables.gpu->projectors().array, tables.texture_quality.lod_bias, upload::any_projector(tables.lights)};
}

inline void declare(graph::Pass&, const Reading&, graph::Access) {}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.sampled(io::projector_pictures, in.pictures, {.lod_bias = in.lod_bias});
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kProjectors, in.any);
}

}  // namespace velarium::projectors
