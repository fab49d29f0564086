#pragma once

#include "gpu/descriptors.hpp"
#include "gpu/null_resources.hpp"
#include "gpu/pipeline_library.hpp"
#include "gpu/samplers.hpp"

namespace velarium::gpu {

// A device and what is made on it once and shared by all who record work.
struct GpuContext {
  explicit GpuContext(Device& device_in)
      : device(device_in),
        samplers(device_in),
        shared_samplers(device_in, samplers),
        pipelines(device_in, shared_samplers),
        descriptors(device_in),
        nulls(device_in) {}
  Device& device;
  SamplerCache samplers;
  SharedSamplers shared_samplers;
  PipelineLibrary pipelines;
  DescriptorAllocator descriptors;  // of the frame being recorded
  NullResources nulls;
};

}  // namespace velarium::gpu
