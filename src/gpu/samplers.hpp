#pragma once

#include "gpu/device.hpp"

#include <map>

namespace velarium::gpu {

struct SamplerDesc {
  VkFilter mag = VK_FILTER_LINEAR, min = VK_FILTER_LINEAR;
  VkSamplerMipmapMode mip = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  VkSamplerAddressMode wrap_u = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, wrap_v = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  bool mipmapped = true;
  float anisotropy = 1.0f;
  float lod_bias = 0.0f;
  bool compare = false;  // of reversed depth: 1 where the reference is at or before what is stored, filtered
  auto operator<=>(const SamplerDesc&) const = default;
};

// For texels that are fetched one by one; not every device filters 32-bit floats.
inline constexpr SamplerDesc kNearest{
    .mag = VK_FILTER_NEAREST, .min = VK_FILTER_NEAREST, .mip = VK_SAMPLER_MIPMAP_MODE_NEAREST};

// Makes each sampler once.
class SamplerCache {
 public:
  explicit SamplerCache(Device& device) : device_(device) {}
  ~SamplerCache();
  SamplerCache(const SamplerCache&) = delete;
  SamplerCache& operator=(const SamplerCache&) = delete;

  [[nodiscard]] VkSampler get(const SamplerDesc& desc);

 private:
  Device& device_;
  std::map<SamplerDesc, VkSampler> samplers_;
};

}  // namespace velarium::gpu
