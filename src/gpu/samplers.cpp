#include "gpu/samplers.hpp"

#include "gpu/check.hpp"

namespace velarium::gpu {

SamplerCache::~SamplerCache() {
  for (const auto& [desc, sampler] : samplers_) vkDestroySampler(device_.vk(), sampler, nullptr);
}

VkSampler SamplerCache::get(const SamplerDesc& desc) {
  if (const auto found = samplers_.find(desc); found != samplers_.end()) return found->second;
  // 0.25 is how the Vulkan specification (GL mapping of VkSamplerCreateInfo) spells "the full-size image alone".
  const float max_lod = desc.mipmapped ? VK_LOD_CLAMP_NONE : 0.25f;
  const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                 .magFilter = desc.mag,
                                 .minFilter = desc.min,
                                 .mipmapMode = desc.mip,
                                 .addressModeU = desc.wrap_u,
                                 .addressModeV = desc.wrap_v,
                                 .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                 .mipLodBias = desc.lod_bias,
                                 .anisotropyEnable = desc.anisotropy > 1.0f,
                                 .maxAnisotropy = desc.anisotropy,
                                 .compareEnable = desc.compare,
                                 .compareOp = VK_COMPARE_OP_GREATER_OR_EQUAL,
                                 .maxLod = max_lod};
  VkSampler sampler = VK_NULL_HANDLE;
  check(vkCreateSampler(device_.vk(), &info, nullptr, &sampler), "vkCreateSampler");
  samplers_.emplace(desc, sampler);
  return sampler;
}

}  // namespace velarium::gpu
