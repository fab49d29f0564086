#pragma once

#include "passes/io.hpp"

namespace velarium::gbuffer {

namespace io {
using namespace shading;
#include "passes/gbuffer/gbuffer_io.glsl"
}  // namespace io

// Opaque surfaces (shading/gbuffer.glsl) as later passes read them: descriptor set 0, beside the frame.
struct Reading {
  graph::GraphImage normal, albedo, specular;
  graph::GraphImage depth;  // and the material class in the stencil
};

inline void declare(graph::Pass& pass, const Reading& in, graph::Access access) {
  for (const auto image : {in.normal, in.albedo, in.specular, in.depth}) pass.read(image, access);
}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.sampled(io::gbuffer_normal, in.normal)
      .sampled(io::gbuffer_albedo, in.albedo)
      .sampled(io::gbuffer_specular, in.specular)
      .sampled(io::gbuffer_depth, in.depth)
      .stencil(io::gbuffer_stencil, in.depth);
}

}  // namespace velarium::gbuffer
