#pragma once

#include "gpu/pipeline.hpp"

#include <deque>
#include <unordered_map>

namespace velarium::gpu {

// Makes each pipeline when it is first asked for, and keeps it: passes can then be plain functions.
// Shaders are told apart by the address of their code, which is static.
class PipelineLibrary {
 public:
  PipelineLibrary(Device& device, const SharedSamplers& samplers) : device_(device), samplers_(samplers) {}

  [[nodiscard]] const Pipeline& compute(Spirv shader, const Specialization& constants = {});
  [[nodiscard]] const Pipeline& raster(Spirv vertex, Spirv fragment, const RasterState& state);

 private:
  struct Compute {
    const std::uint32_t* shader;
    Specialization constants;
    Pipeline pipeline;
  };
  struct Raster {
    const std::uint32_t* vertex;
    const std::uint32_t* fragment;
    RasterState state;
    Pipeline pipeline;
  };
  Device& device_;
  const SharedSamplers& samplers_;
  std::deque<Compute> compute_;  // deques: references stay valid
  std::deque<Raster> raster_;
  std::unordered_multimap<std::uint64_t, const Compute*> compute_by_hash_;
  std::unordered_multimap<std::uint64_t, const Raster*> raster_by_hash_;
};

}  // namespace velarium::gpu
