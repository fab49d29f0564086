#include "gpu/pipeline_library.hpp"

namespace velarium::gpu {

const Pipeline& PipelineLibrary::compute(Spirv shader, const Specialization& constants) {
  for (const auto& known : compute_)
    if (known.shader == shader.data() && known.constants == constants) return known.pipeline;
  return compute_.emplace_back(Compute{shader.data(), constants, Pipeline::compute(device_, shader, constants)})
      .pipeline;
}

const Pipeline& PipelineLibrary::raster(Spirv vertex, Spirv fragment, const RasterState& state) {
  for (const auto& known : raster_)
    if (known.vertex == vertex.data() && known.fragment == fragment.data() && known.state == state)
      return known.pipeline;
  return raster_
      .emplace_back(Raster{vertex.data(), fragment.data(), state, Pipeline::raster(device_, vertex, fragment, state)})
      .pipeline;
}

}  // namespace velarium::gpu
