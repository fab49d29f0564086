#pragma once

#include "gpu/descriptors.hpp"
#include "gpu/pipeline_library.hpp"
#include "gpu/samplers.hpp"

namespace velarium::gpu {

// A device and what is made on it once and shared by all who record work.
struct Toolbox {
  explicit Toolbox(Device& device_in)
      : device(device_in), pipelines(device_in), samplers(device_in), descriptors(device_in) {}
  Device& device;
  PipelineLibrary pipelines;
  SamplerCache samplers;
  DescriptorAllocator descriptors;  // of the frame being recorded
};

}  // namespace velarium::gpu
