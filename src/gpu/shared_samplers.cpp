#include "gpu/shared_samplers.hpp"

#include "gpu/check.hpp"
#include "gpu/slot.hpp"

#include <array>
#include <vector>

namespace velarium::gpu {
namespace {

namespace io {
#include "gpu/samplers.glsl"
}  // namespace io

struct Shared {
  Slot slot;
  SamplerDesc desc;
};
constexpr std::array<Shared, SharedSamplers::kCount> kShared{
    Shared{io::linear_sampler, {}}, Shared{io::nearest_sampler, kNearest},
    Shared{io::equirect_sampler, {.wrap_u = VK_SAMPLER_ADDRESS_MODE_REPEAT}},
    Shared{io::compare_sampler, {.compare = true}}};

}  // namespace

SharedSamplers::SharedSamplers(Device& device, SamplerCache& samplers) : device_(device) {
  std::vector<VkSampler> immutable;
  immutable.reserve(kShared.size());
  for (const auto& shared : kShared) immutable.push_back(samplers.get(shared.desc));
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (std::size_t i = 0; i < kShared.size(); ++i)
    bindings.push_back({kShared[i].slot.binding, VK_DESCRIPTOR_TYPE_SAMPLER, 1,
                        VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT,
                        &immutable[i]});
  const VkDescriptorSetLayoutCreateInfo layout{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                               .bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                               .pBindings = bindings.data()};
  check(vkCreateDescriptorSetLayout(device.vk(), &layout, nullptr, &layout_), "vkCreateDescriptorSetLayout");
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_SAMPLER, static_cast<std::uint32_t>(kShared.size())};
  const VkDescriptorPoolCreateInfo pool{
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
  check(vkCreateDescriptorPool(device.vk(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");
  const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                         .descriptorPool = pool_,
                                         .descriptorSetCount = 1,
                                         .pSetLayouts = &layout_};
  check(vkAllocateDescriptorSets(device.vk(), &info, &set_), "vkAllocateDescriptorSets");
}

SharedSamplers::~SharedSamplers() {
  vkDestroyDescriptorPool(device_.vk(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.vk(), layout_, nullptr);
}

}  // namespace velarium::gpu
