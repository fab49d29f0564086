#include "passes/illumination.hpp"

#include "upload/io.hpp"

namespace velarium::passes {
namespace {

namespace io {
using namespace shading;
#include "passes/illumination_io.glsl"
}  // namespace io

}  // namespace

void declare(graph::Pass& pass, const Illumination& in, graph::Access access) {
  each(in, [&](const auto& reading) { declare(pass, reading, access); });
}

void bind(graph::SetWriter& set, const Illumination& in) {
  set.buffer(upload::io::LightBuffer, in.scene.tables.light_buffer)
      .buffer(upload::io::LightRangeBuffer, in.scene.light_ranges);
  each(in, [&](const auto& reading) { bind(set, reading); });
}

gpu::Specialization specialization(const Illumination& in) {
  gpu::Specialization constants;
  constants.set(io::kModel, static_cast<std::uint32_t>(in.model))
      .set(io::kMultiScatter, in.multi_scatter && in.model == ShadingModel::gltf);
  each(in, [&](const auto& reading) { specialize(constants, reading); });
  return constants;
}

std::uint64_t loop_iterations(const Illumination& in, std::uint64_t lights) {
  return loop_iterations(in.ambient_lights) + lights * (1 + loop_iterations(in.local));
}

}  // namespace velarium::passes
